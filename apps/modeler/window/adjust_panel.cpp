#include "window/adjust_panel.h"

#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>

#include "document/delta.h"
#include "look/theme.h"
#include "panels/number_box.h"

namespace sinew::modeler {
namespace {

constexpr int margin = 14;

}  // namespace

AdjustPanel::AdjustPanel(Model& model, QWidget& viewport, std::function<void(const std::string&)> say)
    : QFrame(&viewport),
      model_(model),
      viewport_(viewport),
      say_(std::move(say)),
      title_(new QLabel),
      form_(new QFormLayout) {
    setObjectName("adjust_panel");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 10);
    column->setSpacing(theme::gap);
    title_->setStyleSheet("font-weight: 600");
    column->addWidget(title_);
    column->addLayout(form_);
    form_->setHorizontalSpacing(10);
    form_->setVerticalSpacing(theme::gap);
    viewport.installEventFilter(this);
    model_.observe([this](const Changes&) {
        if (!busy_) hide();
    });
    hide();
}

void AdjustPanel::perform(Operation operation) {
    operation_ = std::move(operation);
    values_ = values_of(operation_);
    before_ = model_.document();
    selection_before_ = model_.selection();
    ++key_;
    apply();
    make_fields();
    setVisible(!operation_.parameters.empty());
    place();
}

void AdjustPanel::apply() {
    const Result<Document> after = operation_.run(values_);
    if (!after) return say_(after.error().text());
    busy_ = true;
    model_.apply(operation_.label, *after, carried(before_, selection_before_, *after), key_);
    busy_ = false;
    if (same(before_, *after)) say_(operation_.nothing);
}

void AdjustPanel::make_fields() {
    title_->setText(QString::fromStdString(operation_.label));
    while (form_->rowCount() > 0) form_->removeRow(0);
    for (std::size_t i = 0; i < operation_.parameters.size(); ++i) {
        form_->addRow(form_label(QString::fromStdString(operation_.parameters[i].name)), make_field(i));
    }
}

QWidget* AdjustPanel::make_field(std::size_t i) {
    const Parameter& parameter = operation_.parameters[i];
    const QString name = "adjust_" + QString::fromStdString(parameter.name).toLower();
    if (parameter.kind == Parameter::Kind::choice) {
        auto* box = new ChoiceBox;
        box->setObjectName(name);
        for (const std::string& choice : parameter.choices) box->addItem(QString::fromStdString(choice));
        box->setCurrentIndex(static_cast<int>(parameter.value));
        connect(box, &QComboBox::activated, this, [this, i](int index) {
            values_[i] = index;
            apply();
        });
        return box;
    }
    auto* box = new NumberBox;
    box->setObjectName(name);
    box->setToolTip(QString::fromStdString(parameter.tip));
    box->setRange(parameter.least, parameter.most);
    box->setMinimumWidth(110);
    if (parameter.kind == Parameter::Kind::count) {
        box->setDecimals(0);
        box->setStepType(QAbstractSpinBox::DefaultStepType);
    }
    if (parameter.kind == Parameter::Kind::degrees) box->setSuffix("°");
    if (parameter.kind == Parameter::Kind::length && !before_.unit.empty())
        box->setSuffix(" " + QString::fromStdString(before_.unit));
    box->setValue(parameter.value);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, i](double value) {
        values_[i] = value;
        apply();
    });
    return box;
}

void AdjustPanel::place() {
    adjustSize();
    move(margin, viewport_.height() - height() - margin);
    raise();
}

void AdjustPanel::leave() {
    hide();
    viewport_.setFocus();
}

bool AdjustPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) place();
    return QFrame::eventFilter(watched, event);
}

void AdjustPanel::keyPressEvent(QKeyEvent* event) {
    const bool done =
        event->key() == Qt::Key_Escape || event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    done ? leave() : QFrame::keyPressEvent(event);
}

}  // namespace sinew::modeler
