/// @file number_box.h
/// Fields of forms, as the properties and the adjust panel show them.
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <optional>

namespace sinew::modeler {

/// A number that scrolls only when one has clicked it, shows as many digits as it needs, and is empty where
/// values differ.
class NumberBox : public QDoubleSpinBox {
  public:
    explicit NumberBox(QWidget* parent = nullptr);

    /// @param value  nothing: the nodes differ
    void show_value(std::optional<double> value, double otherwise);

    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;

  protected:
    void wheelEvent(QWheelEvent* event) override;

  private:
    bool mixed_ = false;       ///< the nodes differ
    bool typed_over_ = false;  ///< they did until one typed
};

/// A choice that does not change while one scrolls past it.
class ChoiceBox : public QComboBox {
  public:
    using QComboBox::QComboBox;

  protected:
    void wheelEvent(QWheelEvent* event) override;
};

/// The label of a row in a form: level with the field, in the colour of secondary text.
QLabel* form_label(const QString& text);

}  // namespace sinew::modeler
