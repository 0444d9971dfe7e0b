#include "panels/outliner.h"

#include <QHeaderView>
#include <QItemSelectionModel>

namespace sinew::modeler {
namespace {

const std::size_t most_expanded = 3000;  ///< nodes: larger trees open where one looks

}  // namespace

Outliner::Outliner(Model& model, QWidget* parent) : QTreeView(parent), model_(model), items_(model) {
    setObjectName("outliner");
    setModel(&items_);
    setHeaderHidden(true);
    setUniformRowHeights(true);
    setIndentation(14);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setDragDropMode(QAbstractItemView::InternalMove);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    connect(&items_, &QAbstractItemModel::modelReset, this, [this] {
        if (model_.document().nodes.size() <= most_expanded) expandAll();
        show_selection();
    });
    connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] { take_selection(); });
    model_.observe([this](const Changes& changes) {
        if (changes.selection) show_selection();
    });
    expandAll();
    show_selection();
}

/// As wide as the panel at least, so that rows are marked to its end; wider where a tree is deep.
void Outliner::resizeEvent(QResizeEvent* event) {
    QTreeView::resizeEvent(event);
    header()->setMinimumSectionSize(viewport()->width());
}

void Outliner::show_selection() {
    if (busy_) return;
    busy_ = true;
    QItemSelection shown;
    for (std::int32_t node : model_.selection().nodes) {
        const QModelIndex index = items_.index_of(node);
        if (index.isValid()) shown.select(index, index);
    }
    selectionModel()->select(shown, QItemSelectionModel::ClearAndSelect);
    const QModelIndex active = items_.index_of(model_.selection().active);
    if (active.isValid()) {
        selectionModel()->setCurrentIndex(active, QItemSelectionModel::NoUpdate);
        scrollTo(active);
    }
    busy_ = false;
}

void Outliner::take_selection() {
    if (busy_) return;
    busy_ = true;
    std::vector<std::int32_t> nodes;
    for (const QModelIndex& index : selectionModel()->selectedIndexes())
        nodes.push_back(OutlinerModel::node_of(index));
    Selection selection = selection_of(nodes);
    const std::int32_t current = currentIndex().isValid() ? OutlinerModel::node_of(currentIndex()) : -1;
    if (selection.contains(current)) selection.active = current;
    model_.select(std::move(selection));
    busy_ = false;
}

void Outliner::rename_active() {
    const QModelIndex active = items_.index_of(model_.selection().active);
    if (!active.isValid()) return;
    setFocus();
    scrollTo(active);
    edit(active);
}

}  // namespace sinew::modeler
