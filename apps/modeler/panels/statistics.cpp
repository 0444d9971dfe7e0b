#include "panels/statistics.h"

#include <QFormLayout>
#include <QLabel>
#include <QLocale>

#include "look/theme.h"
#include "sinew/skeleton/graph.h"

namespace sinew::modeler {
namespace {

QString grouped(std::int64_t number) {
    return QLocale(QLocale::English).toString(static_cast<qlonglong>(number));
}

QString coloured(const QString& text, const QColor& colour) {
    return QString("<span style='color:%1'>%2</span>").arg(colour.name(), text);
}

}  // namespace

Statistics::Statistics(Model& model, QWidget* parent) : QWidget(parent), model_(model) {
    setObjectName("statistics");
    auto* form = new QFormLayout(this);
    form->setContentsMargins(10, 8, 10, 8);
    form->setVerticalSpacing(4);
    form->setHorizontalSpacing(14);
    form->setLabelAlignment(Qt::AlignRight);
    nodes_ = add(*form, "nodes", "Nodes");
    bones_ = add(*form, "bones", "Bones");
    parts_ = add(*form, "parts", "Parts, cycles");
    vertices_ = add(*form, "vertices", "Vertices");
    quads_ = add(*form, "quads", "Quads");
    triangles_ = add(*form, "triangles", "In fans");
    irregular_ = add(*form, "irregular", "Irregular");
    irregular_->setToolTip(
        "Vertices where not four edges meet, poles included; of the control mesh at most the formula's");
    closed_ = add(*form, "closed", "Surface");
    time_ = add(*form, "time", "Made in");
    model_.observe([this](const Changes& changes) {
        if (changes.document) refresh_skeleton();
    });
    refresh_skeleton();
}

QLabel* Statistics::add(QFormLayout& form, const char* name, const char* label) {
    auto* value = new QLabel("-");
    value->setObjectName(QString("statistics_") + name);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* title = new QLabel(label);
    title->setStyleSheet("color: #98a0ad");
    form.addRow(title, value);
    return value;
}

void Statistics::refresh_skeleton() {
    const Document& document = model_.document();
    const std::vector<Bone> bones = bones_of(document);
    const GraphCounts counts = count_graph(static_cast<std::int32_t>(document.nodes.size()), bones);
    nodes_->setText(grouped(static_cast<std::int64_t>(document.nodes.size())));
    bones_->setText(grouped(static_cast<std::int64_t>(bones.size())));
    parts_->setText(grouped(counts.components) + ", " + grouped(counts.cycles));
}

void Statistics::show_mesh(const std::shared_ptr<const LiveMesh>& mesh) {
    if (!mesh || !mesh->mesh) {
        for (QLabel* label : {vertices_, quads_, triangles_, irregular_, closed_, time_}) label->setText("-");
        return;
    }
    const double all = mesh->skin_ms + mesh->subdivide_ms + mesh->buffers_ms;
    time_->setText(QString("%1 ms").arg(all, 0, 'f', 1));
    time_->setToolTip(QString("Skin %1 ms, subdivide %2 ms, vertex buffers %3 ms")
                          .arg(mesh->skin_ms, 0, 'f', 1)
                          .arg(mesh->subdivide_ms, 0, 'f', 1)
                          .arg(mesh->buffers_ms, 0, 'f', 1));
    // Measured when nothing newer is ordered: until then all figures stay those of the last mesh measured.
    if (!mesh->measures || !mesh->validation) return;
    vertices_->setText(grouped(static_cast<std::int64_t>(mesh->mesh->vertex_count())));
    quads_->setText(grouped(mesh->measures->quads));
    triangles_->setText(grouped(mesh->measures->triangles));
    irregular_->setText(
        QString("%1 of at most %2")
            .arg(grouped(mesh->measures->irregular_vertices), grouped(mesh->irregular_at_most)));
    const bool solid = mesh->validation->solid();
    closed_->setText(solid ? coloured("closed, manifold", theme::fine)
                           : coloured("not a closed manifold", theme::error));
}

}  // namespace sinew::modeler
