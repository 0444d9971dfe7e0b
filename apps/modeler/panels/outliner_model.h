/// @file outliner_model.h
/// The tree of nodes for Qt's views: names and icons, renaming, dragging to another parent.
#pragma once

#include <QAbstractItemModel>
#include <vector>

#include "document/model.h"

namespace sinew::modeler {

/// How a node is called where it has no name: by its type and id.
QString label_of(const Document& document, std::int32_t node);

class OutlinerModel : public QAbstractItemModel {
  public:
    explicit OutlinerModel(Model& model);

    QModelIndex index_of(std::int32_t node) const;
    static std::int32_t node_of(const QModelIndex& index) {
        return static_cast<std::int32_t>(index.internalId());
    }

    QModelIndex index(int row, int column, const QModelIndex& parent) const override;
    QModelIndex parent(const QModelIndex& child) const override;
    int rowCount(const QModelIndex& parent) const override;
    int columnCount(const QModelIndex& parent) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    QStringList mimeTypes() const override;
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    bool canDropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                         const QModelIndex& parent) const override;
    bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                      const QModelIndex& parent) override;

  private:
    /// All that the tree shows of a node; a move in space changes nothing here.
    struct Row {
        std::int32_t parent;
        std::int64_t id;
        NodeType type;
        std::string name;
        bool operator==(const Row&) const = default;
    };
    static std::vector<Row> rows_of(const Document& document);
    static bool same_tree(const std::vector<Row>& a, const std::vector<Row>& b);
    void update();
    void relabel(std::vector<Row> rows);
    const std::vector<std::int32_t>& children(const QModelIndex& parent) const;

    Model& model_;
    std::vector<Row> rows_;
    std::vector<std::vector<std::int32_t>> children_;  ///< by node; the last entry has the roots
    std::vector<int> place_;                           ///< of a node among its siblings
};

}  // namespace sinew::modeler
