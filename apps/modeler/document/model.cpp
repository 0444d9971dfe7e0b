#include "document/model.h"

#include <QUndoCommand>

#include "document/delta.h"

namespace sinew::modeler {

/// One step of the history.
class Model::Edit : public QUndoCommand {
  public:
    Edit(Model& model, const std::string& label, State before, const Document& after, Selection selection,
         int key)
        : QUndoCommand(QString::fromStdString(label)),
          model_(model),
          delta_(before.document, after),
          selection_before_(std::move(before.selection)),
          selection_after_(std::move(selection)),
          key_(key),
          epoch_(model.selection_epoch_) {}

    void undo() override { model_.set(delta_.backward(model_.document_), selection_before_); }

    void redo() override { model_.set(delta_.forward(model_.document_), selection_after_); }

    int id() const override { return key_ == 0 ? -1 : key_; }

    bool mergeWith(const QUndoCommand* next) override {
        const auto& later = static_cast<const Edit&>(*next);
        if (later.epoch_ != epoch_ || later.text() != text()) return false;
        // The model already shows the later document.
        Document middle = later.delta_.backward(model_.document_);
        delta_ = DocumentDelta(delta_.backward(std::move(middle)), model_.document_);
        selection_after_ = later.selection_after_;
        setObsolete(delta_.empty());
        return true;
    }

  private:
    Model& model_;
    DocumentDelta delta_;
    Selection selection_before_, selection_after_;
    int key_, epoch_;
};

Model::Model() { history_.setUndoLimit(1000); }

void Model::select(Selection selection) {
    if (selection == selection_) return;
    selection_ = std::move(selection);
    ++selection_epoch_;
    tell({.selection = true});
}

void Model::apply(const std::string& label, Document next, Selection selection, MergeKey key) {
    if (previewing()) cancel();
    if (same(document_, next)) return select(std::move(selection));
    history_.push(new Edit(*this, label, {document_, selection_}, next, std::move(selection), key));
}

void Model::preview(Document next, Selection selection) {
    if (!before_drag_) before_drag_ = State{document_, selection_};
    set(std::move(next), std::move(selection));
}

void Model::commit(const std::string& label) {
    if (!before_drag_) return;
    State before = std::move(*before_drag_), after{document_, selection_};
    before_drag_.reset();
    document_ = before.document;  // the command's redo brings the new one back
    if (same(before.document, after.document))
        return set(std::move(before.document), std::move(after.selection));
    history_.push(new Edit(*this, label, std::move(before), after.document, std::move(after.selection), 0));
}

void Model::cancel() {
    if (!before_drag_) return;
    State before = std::move(*before_drag_);
    before_drag_.reset();
    set(std::move(before.document), std::move(before.selection));
}

void Model::undo() {
    if (previewing()) return cancel();
    history_.undo();
}

void Model::redo() {
    if (!previewing()) history_.redo();
}

void Model::replace(Document document, bool saved) {
    before_drag_.reset();
    history_.clear();
    if (!saved) history_.resetClean();
    document_ = std::move(document);
    selection_ = {};
    ++revision_;
    ++selection_epoch_;
    tell({.document = true, .selection = true, .replaced = true});
}

void Model::set(Document document, Selection selection) {
    const bool reselected = !(selection == selection_);
    document_ = std::move(document);
    selection_ = std::move(selection);
    ++revision_;
    tell({.document = true, .selection = reselected});
}

void Model::tell(const Changes& changes) {
    for (const Observer& observer : observers_) observer(changes);
}

}  // namespace sinew::modeler
