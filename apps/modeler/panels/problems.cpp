#include "panels/problems.h"

#include <QPainter>
#include <algorithm>

#include "look/theme.h"
#include "sinew/skeleton/validate.h"

namespace sinew::modeler {
namespace {

constexpr std::size_t most_shown = 200;
constexpr int ids_role = Qt::UserRole;

QIcon dot(const QColor& colour) {
    QPixmap pixmap(32, 32);
    pixmap.setDevicePixelRatio(2);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(QPointF(8, 8), 4.5, 4.5);
    return pixmap;
}

/// Without the place in a file that may not be: the node is enough.
std::string text_of(Error error) {
    error.path.clear();
    return error.text();
}

Selection nodes_with(const Document& document, const QVariantList& ids) {
    std::vector<std::int32_t> nodes;
    for (const QVariant& id : ids)
        for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i)
            if (document.nodes[i].id == id.toLongLong()) nodes.push_back(i);
    return selection_of(nodes);
}

}  // namespace

Problems::Problems(Model& model, QWidget* parent) : QListWidget(parent), model_(model) {
    setObjectName("problems");
    setWordWrap(true);
    setTextElideMode(Qt::ElideNone);
    connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) {
        const Selection nodes = nodes_with(model_.document(), item->data(ids_role).toList());
        if (!nodes.empty()) model_.select(nodes);
    });
    model_.observe([this](const Changes& changes) {
        if (changes.replaced) reading_.clear();
        if (changes.document && !model_.previewing()) refresh();
    });
    refresh();
}

void Problems::show_mesh(const std::shared_ptr<const LiveMesh>& mesh) {
    mesh_ = mesh;
    if (!model_.previewing()) refresh();
}

void Problems::show_reading(const Warnings& warnings) {
    reading_ = warnings;
    refresh();
}

void Problems::add(Weight weight, const std::string& text, const std::vector<std::int64_t>& ids) {
    auto* item = new QListWidgetItem(dot(weight == Weight::error ? theme::error : theme::warning),
                                     QString::fromStdString(text));
    QVariantList list;
    for (std::int64_t id : ids) list << static_cast<qlonglong>(id);
    item->setData(ids_role, list);
    if (!ids.empty()) item->setToolTip("Click to select");
    addItem(item);
}

void Problems::refresh() {
    clear();
    const std::vector<Error> found = problems(model_.document(), most_shown);
    auto ids_of = [](const Error& error) {
        return error.node ? std::vector<std::int64_t>{*error.node} : std::vector<std::int64_t>{};
    };
    for (const Error& error : found) add(Weight::error, text_of(error), ids_of(error));
    // While the document is unsound the mesher says the same once more.
    if (mesh_ && mesh_->error && found.empty() && !model_.document().nodes.empty())
        add(Weight::error, text_of(*mesh_->error), ids_of(*mesh_->error));
    const auto said = [&](const Warning& warning) {
        return std::any_of(found.begin(), found.end(),
                           [&](const Error& e) { return e.message == warning.message; });
    };
    for (const Warning& warning : reading_)
        if (!said(warning)) add(Weight::warning, warning.message, warning.nodes);
    if (mesh_)
        for (const Warning& warning : mesh_->warnings) add(Weight::warning, warning.message, warning.nodes);
    if (counted) counted(count());
}

}  // namespace sinew::modeler
