/// @file model.h
/// The open document, what is selected in it, and its history. Every change goes through here.
///
/// An edit is a value: the caller makes the next document with a pure function and hands it over with a
/// label. A drag previews as many documents as it likes and commits one of them, as one step.
#pragma once

#include <QUndoStack>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "document/selection.h"
#include "sinew/skeleton/document.h"

namespace sinew::modeler {

/// What observers are told of.
struct Changes {
    bool document = false;
    bool selection = false;
    bool replaced = false;  ///< another document altogether: new, open, recover
};

class Model {
  public:
    using Observer = std::function<void(const Changes&)>;
    /// Edits that follow each other with the same key become one step (the wheel, a spin box); 0 never
    /// merges.
    using MergeKey = int;

    Model();

    const Document& document() const { return document_; }
    const Selection& selection() const { return selection_; }

    void select(Selection selection);

    /// One undo step; nothing at all where the document stays as it is (the selection still changes).
    void apply(const std::string& label, Document next, Selection selection, MergeKey key = 0);
    void apply(const std::string& label, Document next) { apply(label, std::move(next), selection_); }

    /// @name A drag: the first preview starts it, commit makes it one step, cancel takes it all back.
    /// @{
    void preview(Document next, Selection selection);
    bool previewing() const { return before_drag_.has_value(); }
    const Document& before_drag() const { return before_drag_ ? before_drag_->document : document_; }
    void commit(const std::string& label);
    void cancel();
    /// @}

    void undo();
    void redo();

    /// Another document; forgets the history. `saved`: it is what the file holds.
    void replace(Document document, bool saved);

    /// For the history panel and the labels of undo and redo.
    QUndoStack& history() { return history_; }
    const QUndoStack& history() const { return history_; }
    bool modified() const { return !history_.isClean(); }
    void mark_saved() { history_.setClean(); }

    /// Counts every change of the document, previews and undo included.
    std::uint64_t revision() const { return revision_; }

    /// Observers are called after the change, in the order in which they came; they live as long as the
    /// model.
    void observe(Observer observer) { observers_.push_back(std::move(observer)); }

  private:
    struct State {
        Document document;
        Selection selection;
    };
    class Edit;

    void set(Document document, Selection selection);
    void tell(const Changes& changes);

    Document document_;
    Selection selection_;
    std::optional<State> before_drag_;
    QUndoStack history_;
    std::vector<Observer> observers_;
    std::uint64_t revision_ = 0;
    int selection_epoch_ = 0;
};

}  // namespace sinew::modeler
