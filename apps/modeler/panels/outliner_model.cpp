#include "panels/outliner_model.h"

#include <QIODevice>
#include <QIcon>
#include <QMimeData>
#include <algorithm>

#include "document/edits.h"
#include "look/icons.h"

namespace sinew::modeler {
namespace {

const char* const mime = "application/x-sinew-node";
const char* const type_words[] = {"Node", "Cone", "Flat end", "Cube", "Negative", "Ball"};

std::int32_t node_in(const QMimeData* data) {
    return data && data->hasFormat(mime) ? data->data(mime).toInt() : -1;
}

}  // namespace

QString label_of(const Document& document, std::int32_t i) {
    if (!document.names.empty() && !document.names[i].empty())
        return QString::fromStdString(document.names[i]);
    const Node& node = document.nodes[i];
    const bool plain_root = node.parent < 0 && node.type == NodeType::sphere;
    return QString("%1 %2").arg(plain_root ? "Root" : type_words[static_cast<int>(node.type)]).arg(node.id);
}

OutlinerModel::OutlinerModel(Model& model) : model_(model) {
    update();
    model_.observe([this](const Changes& changes) {
        if (changes.document) update();
    });
}

std::vector<OutlinerModel::Row> OutlinerModel::rows_of(const Document& document) {
    std::vector<Row> rows;
    rows.reserve(document.nodes.size());
    for (std::size_t i = 0; i < document.nodes.size(); ++i) {
        const Node& node = document.nodes[i];
        rows.push_back(
            {node.parent, node.id, node.type, document.names.empty() ? std::string() : document.names[i]});
    }
    return rows;
}

bool OutlinerModel::same_tree(const std::vector<Row>& a, const std::vector<Row>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Row& x, const Row& y) { return x.parent == y.parent; });
}

void OutlinerModel::update() {
    std::vector<Row> rows = rows_of(model_.document());
    if (rows == rows_ && !children_.empty()) return;
    if (same_tree(rows, rows_) && !children_.empty()) return relabel(std::move(rows));
    beginResetModel();
    rows_ = std::move(rows);
    children_.assign(rows_.size() + 1, {});
    place_.assign(rows_.size(), 0);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        auto& siblings =
            children_[rows_[i].parent < 0 ? rows_.size() : static_cast<std::size_t>(rows_[i].parent)];
        place_[i] = static_cast<int>(siblings.size());
        siblings.push_back(static_cast<std::int32_t>(i));
    }
    endResetModel();
}

/// Names and types change in place: views keep what is open, and the editor that a name was typed in.
void OutlinerModel::relabel(std::vector<Row> rows) {
    std::swap(rows_, rows);
    for (std::int32_t i = 0; i < std::ssize(rows_); ++i)
        if (rows_[i] != rows[i]) emit dataChanged(index_of(i), index_of(i));
}

const std::vector<std::int32_t>& OutlinerModel::children(const QModelIndex& parent) const {
    return parent.isValid() ? children_[node_of(parent)] : children_.back();
}

QModelIndex OutlinerModel::index_of(std::int32_t node) const {
    if (node < 0 || node >= std::ssize(rows_)) return {};
    return createIndex(place_[node], 0, static_cast<quintptr>(node));
}

QModelIndex OutlinerModel::index(int row, int column, const QModelIndex& parent) const {
    if (!hasIndex(row, column, parent)) return {};
    return createIndex(row, column, static_cast<quintptr>(children(parent)[row]));
}

QModelIndex OutlinerModel::parent(const QModelIndex& child) const {
    return child.isValid() ? index_of(rows_[node_of(child)].parent) : QModelIndex();
}

int OutlinerModel::rowCount(const QModelIndex& parent) const {
    return static_cast<int>(children(parent).size());
}

int OutlinerModel::columnCount(const QModelIndex&) const { return 1; }

QVariant OutlinerModel::data(const QModelIndex& index, int role) const {
    const std::int32_t node = node_of(index);
    if (!index.isValid() || node >= std::ssize(model_.document().nodes)) return {};
    switch (role) {
        case Qt::DisplayRole:
            return label_of(model_.document(), node);
        case Qt::EditRole:
            return QString::fromStdString(rows_[node].name);
        case Qt::DecorationRole:
            return icon_of(model_.document().nodes[node]);
        default:
            return {};
    }
}

bool OutlinerModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole) return false;
    model_.apply("Rename",
                 rename(model_.document(), node_of(index), value.toString().trimmed().toStdString()));
    return true;
}

Qt::ItemFlags OutlinerModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::ItemIsDropEnabled;
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsDragEnabled |
           Qt::ItemIsDropEnabled;
}

QStringList OutlinerModel::mimeTypes() const { return {mime}; }

QMimeData* OutlinerModel::mimeData(const QModelIndexList& indexes) const {
    auto* data = new QMimeData;
    if (!indexes.isEmpty()) data->setData(mime, QByteArray::number(node_of(indexes.first())));
    return data;
}

bool OutlinerModel::canDropMimeData(const QMimeData* data, Qt::DropAction, int, int,
                                    const QModelIndex& parent) const {
    const std::int32_t node = node_in(data);
    return node >= 0 && node < std::ssize(rows_) &&
           may_reparent(model_.document(), node, parent.isValid() ? node_of(parent) : -1);
}

bool OutlinerModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                 const QModelIndex& parent) {
    if (!canDropMimeData(data, action, row, column, parent)) return false;
    const std::int32_t above = parent.isValid() ? node_of(parent) : -1;
    model_.apply("Re-parent", reparent(model_.document(), node_in(data), above));
    return false;  // nothing for the view to remove: the model was reset
}

}  // namespace sinew::modeler
