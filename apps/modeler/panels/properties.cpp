#include "panels/properties.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

#include "look/icons.h"
#include "look/theme.h"
#include "panels/number_box.h"
#include "panels/outliner_model.h"

namespace sinew::modeler {
namespace {

const char* const type_labels[] = {"Sphere", "Cone", "Flat end", "Cube", "Negative", "Ball"};
const char* const type_icons[] = {"type.sphere", "type.cone",     "type.hemisphere",
                                  "type.cube",   "type.negative", "type.ball"};

template <class T>
std::optional<T> common(const Document& document, const std::vector<std::int32_t>& nodes, T Node::*member) {
    if (nodes.empty()) return std::nullopt;
    for (std::int32_t i : nodes)
        if (document.nodes[i].*member != document.nodes[nodes.front()].*member) return std::nullopt;
    return document.nodes[nodes.front()].*member;
}

/// "Position X", then only "Y" and "Z", each in the colour of its axis.
QLabel* row_label(const Field& field, bool first) {
    const QString part = field.label;
    const qsizetype axis = part.size() == 1 ? QString("XYZ").indexOf(part) : -1;
    const QString shown =
        axis < 0 ? part : QString("<b style='color:%1'>%2</b>").arg(theme::axis[axis].name(), part);
    QLabel* label = form_label(first ? QString(field.group) + "&nbsp; " + shown : shown);
    label->setTextFormat(Qt::RichText);
    label->setToolTip(field.tip);
    return label;
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
    form.addRow(form_label("Name"), name_);
    connect(name_, &QLineEdit::editingFinished, this, [this] {
        if (busy_ || model_.selection().nodes.size() != 1) return;
        model_.apply("Rename", rename(model_.document(), model_.selection().active,
                                      name_->text().trimmed().toStdString()));
    });
    type_ = new ChoiceBox;
    type_->setObjectName("type");
    for (int i = 0; i < 6; ++i) type_->addItem(icon(type_icons[i]), type_labels[i]);
    form.addRow(form_label("Type"), type_);
    connect(type_, &QComboBox::activated, this, [this](int i) {
        model_.apply("Type", set_type(model_.document(), model_.selection().nodes, static_cast<NodeType>(i)));
        refresh();
    });
    section_ = new ChoiceBox;
    section_->setObjectName("section");
    section_->addItems({"Round", "Rectangular"});
    form.addRow(form_label("Sides"), section_);
    connect(section_, &QComboBox::activated, this, [this](int i) {
        model_.apply("Section", set(model_.document(), model_.selection().nodes, &Node::section,
                                    static_cast<Section>(i)));
    });
    rows_ = {name_, type_, section_};
    unit_ = new ChoiceBox;
    unit_->setObjectName("unit");
    unit_->setEditable(true);
    unit_->addItems({"", "m", "cm", "mm", "um", "nm"});
    unit_->setToolTip("What all lengths are in; figures stay as they are");
    unit_->lineEdit()->setPlaceholderText("unknown");
    form.addRow(form_label("Unit"), unit_);
    connect(unit_, &QComboBox::activated, this, [this] { put_unit(); });
    connect(unit_->lineEdit(), &QLineEdit::editingFinished, this, [this] { put_unit(); });
}

void Properties::add_fields(QFormLayout& form) {
    QString group;
    for (const Field& field : fields()) {
        NumberBox* box = make_box(field);
        form.addRow(row_label(field, group != field.group), box);
        group = field.group;
        boxes_.push_back({&field, box});
    }
}

NumberBox* Properties::make_box(const Field& field) {
    auto* box = new NumberBox;
    box->setObjectName(field.id);
    box->setToolTip(field.tip);
    box->setRange(field.least, field.most);
    if (field.unit == Unit::degrees) {
        box->setSuffix("°");
        box->setStepType(QAbstractSpinBox::DefaultStepType);
        box->setSingleStep(5);
    }
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, &field](double value) { put(field, value); });
    return box;
}

void Properties::put_unit() {
    if (busy_) return;
    Document next = model_.document();
    next.unit = unit_->currentText().trimmed().toStdString();
    model_.apply("Unit", std::move(next));
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
    const Document& document = model_.document();
    const std::vector<std::int32_t>& nodes = model_.selection().nodes;
    const bool shown = !nodes.empty() && relevant_to_all(document, nodes, *box.field);
    form_->setRowVisible(box.widget, shown);
    if (!shown) return;
    const auto value = common_value(document, nodes, *box.field);
    if (box.field->unit == Unit::length)
        box.widget->setSuffix(document.unit.empty() || !value ? ""
                                                              : " " + QString::fromStdString(document.unit));
    box.widget->show_value(value, box.field->get(document, nodes.front()));
}

void Properties::refresh() {
    busy_ = true;
    const std::vector<std::int32_t>& nodes = model_.selection().nodes;
    for (QWidget* row : rows_) form_->setRowVisible(row, !nodes.empty());
    form_->setRowVisible(unit_, nodes.empty());
    if (!unit_->hasFocus()) unit_->setEditText(QString::fromStdString(model_.document().unit));
    if (nodes.empty()) {
        title_->setText(
            QString("<span style='color:%1'>Nothing selected</span>").arg(theme::dim_text.name()));
    } else {
        title_->setText(nodes.size() == 1
                            ? "<b>" + label_of(model_.document(), nodes[0]).toHtmlEscaped() + "</b>"
                            : QString("<b>%1 nodes</b>").arg(nodes.size()));
        refresh_choices();
    }
    for (const Box& box : boxes_) refresh_box(box);
    busy_ = false;
}

}  // namespace sinew::modeler
