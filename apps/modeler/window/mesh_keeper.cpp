#include "window/mesh_keeper.h"

namespace sinew::modeler {

MeshKeeper::MeshKeeper(Model& model, const ViewSettings& view, Show show)
    : model_(model),
      view_(view),
      show_(std::move(show)),
      mesher_([this](std::shared_ptr<const LiveMesh> mesh) {
          QMetaObject::invokeMethod(
              &receiver_,
              [this, mesh = std::move(mesh)] {
                  mesh_ = mesh;
                  show_(mesh);
              },
              Qt::QueuedConnection);
      }) {
    model_.observe([this](const Changes& changes) {
        if (changes.document) refresh();
    });
}

MeshOptions MeshKeeper::options() const {
    return {.level = view_.level, .sides = view_.sides, .repair = repair_};
}

void MeshKeeper::set_repair(bool repair) {
    repair_ = repair;
    refresh();
}

void MeshKeeper::refresh() {
    if (!view_.live || (ordered_revision_ == model_.revision() && ordered_options_ == options())) return;
    ordered_revision_ = model_.revision();
    ordered_options_ = options();
    mesher_.order(model_.document(), ordered_options_, ordered_revision_);
}

}  // namespace sinew::modeler
