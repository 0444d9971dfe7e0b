#include "panels/properties.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QWheelEvent>
#include <cmath>

#include "panels/outliner_model.h"
#include "window/icons.h"
#include "window/theme.h"

namespace sinew::modeler {
namespace {

const char* const type_labels[] = {"Sphere", "Cone", "Flat end", "Cube", "Negative", "Ball"};
const char* const type_icons[] = {"type.sphere", "type.cone",     "type.hemisphere",
                                  "type.cube",   "type.negative", "type.ball"};

/// A number that scrolls only when one has clicked it, shows as many digits as it needs, and is empty where
/// values differ.
class NumberBox : public QDoubleSpinBox {
  public:
    using QDoubleSpinBox::QDoubleSpinBox;
    bool mixed = false;
    using QDoubleSpinBox::lineEdit;

    QString textFromValue(double value) const override {
        if (mixed) return {};
        return QLocale::c().toString(value, 'g', 6);
    }
    double valueFromText(const QString& text) const override {
        return QLocale::c().toDouble(QString(text).remove(suffix()).trimmed());
    }
    QValidator::State validate(QString& text, int&) const override {
        const QString number = QString(text).remove(suffix()).trimmed();
        bool good = false;
        QLocale::c().toDouble(number, &good);
        return good ? QValidator::Acceptable : QValidator::Intermediate;
    }
    void wheelEvent(QWheelEvent* event) override {
        if (hasFocus())
            QDoubleSpinBox::wheelEvent(event);
        else
            event->ignore();
    }
};

/// The same for choices.
class ChoiceBox : public QComboBox {
  public:
    using QComboBox::QComboBox;
    void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

template <class T>
std::optional<T> common(const Document& document, const std::vector<std::int32_t>& nodes, T Node::*member) {
    if (nodes.empty()) return std::nullopt;
    for (std::int32_t i : nodes)
        if (document.nodes[i].*member != document.nodes[nodes.front()].*member) return std::nullopt;
    return document.nodes[nodes.front()].*member;
}

}  // namespace

Properties::Properties(Model& model, QWidget* parent) : QScrollArea(parent), model_(model) {
    setObjectName("properties");
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* page = new QWidget;
    form_ = new QFormLayout(page);
    form_->setContentsMargins(10, 8, 10, 8);
    form_->setHorizontalSpacing(10);
    form_->setVerticalSpacing(theme::gap);
    form_->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    add_head(*form_);
    add_fields(*form_);
    setWidget(page);
    model_.observe([this](const Changes&) { refresh(); });
    refresh();
}

void Properties::add_head(QFormLayout& form) {
    title_ = new QLabel;
    title_->setObjectName("properties_title");
    form.addRow(title_);
    name_ = new QLineEdit;
    name_->setObjectName("name");
    name_->setPlaceholderText("no name");
    form.addRow("Name", name_);
    connect(name_, &QLineEdit::editingFinished, this, [this] {
        if (busy_ || model_.selection().nodes.size() != 1) return;
        model_.apply("Rename", rename(model_.document(), model_.selection().active,
                                      name_->text().trimmed().toStdString()));
    });
    type_ = new ChoiceBox;
    type_->setObjectName("type");
    for (int i = 0; i < 6; ++i) type_->addItem(icon(type_icons[i]), type_labels[i]);
    form.addRow("Type", type_);
    connect(type_, &QComboBox::activated, this, [this](int i) {
        model_.apply("Type", set_type(model_.document(), model_.selection().nodes, static_cast<NodeType>(i)));
        refresh();
    });
    section_ = new ChoiceBox;
    section_->setObjectName("section");
    section_->addItems({"Round", "Rectangular"});
    form.addRow("Sides", section_);
    connect(section_, &QComboBox::activated, this, [this](int i) {
        model_.apply("Section", set(model_.document(), model_.selection().nodes, &Node::section,
                                    static_cast<Section>(i)));
    });
    rows_ = {name_, type_, section_};
}

void Properties::add_fields(QFormLayout& form) {
    QWidget* row = nullptr;
    QString group;
    for (const Field& field : fields()) {
        if (field.group != group) {
            group = field.group;
            row = new QWidget;
            auto* line = new QHBoxLayout(row);
            line->setContentsMargins(0, 0, 0, 0);
            line->setSpacing(4);
            form.addRow(group, row);
            rows_.push_back(row);
        }
        QDoubleSpinBox* box = make_box(field);
        row->layout()->addWidget(box);
        boxes_.push_back({&field, box, row});
    }
}

QDoubleSpinBox* Properties::make_box(const Field& field) {
    auto* box = new NumberBox;
    box->setObjectName(field.id);
    box->setToolTip(QString(field.tip) + (*field.label ? QString(" (%1)").arg(field.label) : QString()));
    box->setDecimals(9);
    box->setRange(field.least, field.most);
    box->setMinimumWidth(52);
    box->setKeyboardTracking(false);
    if (field.unit == Unit::degrees) box->setSuffix("°");
    box->setStepType(field.unit == Unit::degrees ? QAbstractSpinBox::DefaultStepType
                                                 : QAbstractSpinBox::AdaptiveDecimalStepType);
    if (field.unit == Unit::degrees) box->setSingleStep(5);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, &field](double value) { put(field, value); });
    return box;
}

void Properties::put(const Field& field, double value) {
    if (busy_ || model_.selection().empty()) return;
    const int key = 100 + static_cast<int>(&field - fields().data());
    model_.apply(field.group, with_value(model_.document(), model_.selection().nodes, field, value),
                 model_.selection(), key);
}

void Properties::refresh_choices() {
    const Document& document = model_.document();
    const std::vector<std::int32_t>& nodes = model_.selection().nodes;
    const auto type = common(document, nodes, &Node::type);
    type_->setCurrentIndex(type ? static_cast<int>(*type) : -1);
    const auto section = common(document, nodes, &Node::section);
    section_->setCurrentIndex(section ? static_cast<int>(*section) : -1);
    const bool one = nodes.size() == 1;
    name_->setEnabled(one);
    if (!name_->hasFocus() || !one)
        name_->setText(one && !document.names.empty() ? QString::fromStdString(document.names[nodes[0]])
                                                      : QString());
}

void Properties::refresh_box(const Box& box) {
    const std::vector<std::int32_t>& nodes = model_.selection().nodes;
    const bool shown = relevant_to_all(model_.document(), nodes, *box.field);
    box.widget->setVisible(shown);
    if (!shown) return;
    auto& number = static_cast<NumberBox&>(*box.widget);
    const auto value = common_value(model_.document(), nodes, *box.field);
    number.mixed = !value;
    if (box.field->unit == Unit::length)
        number.setSuffix(model_.document().unit.empty() || number.mixed
                             ? ""
                             : " " + QString::fromStdString(model_.document().unit));
    // Writing the text anew while one types in it would move the cursor.
    if (value && number.value() == *value && number.hasFocus()) return;
    number.setValue(value.value_or(box.field->get(model_.document(), nodes.front())));
    if (number.mixed) number.lineEdit()->setPlaceholderText("differ"), number.lineEdit()->clear();
}

void Properties::refresh() {
    busy_ = true;
    const std::vector<std::int32_t>& nodes = model_.selection().nodes;
    for (QWidget* row : rows_) form_->setRowVisible(row, !nodes.empty());
    if (nodes.empty()) {
        title_->setText("<span style='color:#98a0ad'>Nothing selected</span>");
    } else {
        title_->setText(nodes.size() == 1
                            ? "<b>" + label_of(model_.document(), nodes[0]).toHtmlEscaped() + "</b>"
                            : QString("<b>%1 nodes</b>").arg(nodes.size()));
        refresh_choices();
        for (const Box& box : boxes_) refresh_box(box);
        for (QWidget* row : rows_) {
            bool any = row->findChildren<QDoubleSpinBox*>().isEmpty();
            for (const Box& box : boxes_) any = any || (box.row == row && !box.widget->isHidden());
            form_->setRowVisible(row, any);
        }
    }
    busy_ = false;
}

}  // namespace sinew::modeler
