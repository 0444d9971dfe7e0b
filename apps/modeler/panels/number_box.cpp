#include "panels/number_box.h"

#include <QLineEdit>
#include <QWheelEvent>
#include <utility>

namespace sinew::modeler {

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setDecimals(9);
    setMinimumWidth(52);
    setKeyboardTracking(false);
    setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    connect(lineEdit(), &QLineEdit::textEdited, this, [this](const QString& text) {
        if (!mixed_ && !typed_over_) return;
        mixed_ = text.isEmpty();
        typed_over_ = !mixed_;
    });
    // What is typed over nodes that differ is for all of them, even if the box held this number already.
    connect(this, &QAbstractSpinBox::editingFinished, this, [this] {
        if (std::exchange(typed_over_, false)) emit valueChanged(value());
    });
}

void NumberBox::show_value(std::optional<double> value, double otherwise) {
    mixed_ = !value;
    typed_over_ = false;
    // Writing the text anew while one types in it would move the cursor.
    if (value && this->value() == *value && hasFocus()) return;
    setValue(value.value_or(otherwise));
    if (!mixed_) return;
    lineEdit()->setPlaceholderText("differ");
    lineEdit()->clear();
}

QString NumberBox::textFromValue(double value) const {
    return mixed_ ? QString() : QLocale::c().toString(value, 'g', 6);
}

double NumberBox::valueFromText(const QString& text) const {
    return QLocale::c().toDouble(QString(text).remove(suffix()).trimmed());
}

QValidator::State NumberBox::validate(QString& text, int&) const {
    const QString number = QString(text).remove(suffix()).trimmed();
    bool good = false;
    QLocale::c().toDouble(number, &good);
    return good ? QValidator::Acceptable : QValidator::Intermediate;
}

void NumberBox::wheelEvent(QWheelEvent* event) {
    hasFocus() ? QDoubleSpinBox::wheelEvent(event) : event->ignore();
}

void ChoiceBox::wheelEvent(QWheelEvent* event) { event->ignore(); }

QLabel* form_label(const QString& text) {
    auto* label = new QLabel(text);
    label->setProperty("dim", true);
    label->setMinimumHeight(27);  // of a field
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return label;
}

}  // namespace sinew::modeler
