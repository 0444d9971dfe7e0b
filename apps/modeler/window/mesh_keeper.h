/// @file mesh_keeper.h
/// Keeps the mesh in step with the document: orders one after every change, hands it on when it is there.
#pragma once

#include <QObject>
#include <functional>
#include <memory>

#include "document/model.h"
#include "document/view_settings.h"
#include "live/mesher.h"

namespace sinew::modeler {

class MeshKeeper {
  public:
    using Show = std::function<void(std::shared_ptr<const LiveMesh>)>;
    /// @param show  called on the thread of the window
    MeshKeeper(Model& model, const ViewSettings& view, Show show);

    /// Orders a mesh if the document or the settings have changed since the last order.
    void refresh();
    void set_repair(bool repair);  ///< the document was measured
    MeshOptions options() const;

    /// The last mesh that was shown; null at first.
    const std::shared_ptr<const LiveMesh>& mesh() const { return mesh_; }
    /// True if what is shown is that of the document and of the settings as they are now.
    bool up_to_date() const {
        return mesh_ && mesh_->revision == model_.revision() && mesh_->options == options();
    }

  private:
    Model& model_;
    const ViewSettings& view_;
    Show show_;
    bool repair_ = false;
    std::shared_ptr<const LiveMesh> mesh_;
    std::uint64_t ordered_revision_ = ~0ull;
    MeshOptions ordered_options_;
    QObject receiver_;  ///< what the worker sends after this is gone is dropped with it
    Mesher mesher_;
};

}  // namespace sinew::modeler
