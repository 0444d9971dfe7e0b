/// @file properties.h
/// All fields of what is selected: for many nodes at once, where they differ the field is empty.
#pragma once

#include <QScrollArea>
#include <vector>

#include "document/fields.h"
#include "document/model.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace sinew::modeler {

class NumberBox;

class Properties : public QScrollArea {
  public:
    explicit Properties(Model& model, QWidget* parent = nullptr);

  private:
    struct Box {
        const Field* field;
        NumberBox* widget;
    };
    void add_head(QFormLayout& form);
    void add_fields(QFormLayout& form);
    NumberBox* make_box(const Field& field);
    void refresh();
    void refresh_choices();
    void refresh_box(const Box& box);
    void put(const Field& field, double value);
    void put_unit();

    Model& model_;
    QLabel* title_ = nullptr;
    QLineEdit* name_ = nullptr;
    QComboBox* type_ = nullptr;
    QComboBox* section_ = nullptr;
    QComboBox* unit_ = nullptr;  ///< of the document: shown where nothing is selected
    QFormLayout* form_ = nullptr;
    std::vector<Box> boxes_;
    std::vector<QWidget*> rows_;
    bool busy_ = false;
};

}  // namespace sinew::modeler
