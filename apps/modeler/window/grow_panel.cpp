#include "window/grow_panel.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QSpinBox>
#include <cmath>
#include <random>

#include "files/load.h"
#include "look/icons.h"
#include "look/theme.h"
#include "panels/number_box.h"
#include "sinew/io/files.h"

namespace sinew::modeler {
namespace {

constexpr int usual_limit = 100'000;  ///< nodes: more than this is no longer live
constexpr int notches = 200;          ///< of a slider
constexpr int most_seeds = 1'000'000;

QSpinBox* whole_number(const char* name, int least, int most) {
    auto* box = new QSpinBox;
    box->setObjectName(name);
    box->setRange(least, most);
    box->setKeyboardTracking(false);
    return box;
}

QLabel* remark_label(const std::string& remark) {
    auto* label = new QLabel(QString::fromStdString(remark));
    label->setProperty("dim", true);
    label->setWordWrap(true);
    label->setContentsMargins(0, 6, 0, 0);
    return label;
}

/// What a slider reaches: from nothing to twice what the file says.
double reach_of(double value) { return value == 0 ? 1 : 2 * value; }

}  // namespace

GrowPanel::GrowPanel(Model& model, QWidget* parent)
    : QDockWidget("Grow from L-system", parent), model_(model) {
    setObjectName("grow_panel");
    setWidget(make_page());
    grower_ = std::make_unique<Grower>([this](std::shared_ptr<const Grown> grown) {
        QMetaObject::invokeMethod(
            this, [this, grown = std::move(grown)] { take(*grown); }, Qt::QueuedConnection);
    });
}

QWidget* GrowPanel::make_page() {
    auto* page = new QWidget;
    page->setMinimumWidth(300);
    auto* column = new QVBoxLayout(page);
    column->setSpacing(10);
    head_ = new QFormLayout;
    head_->setHorizontalSpacing(12);
    column->addLayout(head_);
    make_head();
    auto* list = new QWidget;
    constants_ = new QFormLayout(list);
    constants_->setContentsMargins(0, 4, 8, 4);
    constants_->setHorizontalSpacing(12);
    auto* scroll = new QScrollArea;
    scroll->setWidget(list);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    column->addWidget(scroll, 1);
    state_ = new QLabel;
    state_->setObjectName("grow_state");
    state_->setWordWrap(true);
    column->addWidget(state_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    accept_ = buttons->button(QDialogButtonBox::Ok);
    accept_->setText("Grow");
    accept_->setDefault(true);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] { finish(true); });
    connect(buttons, &QDialogButtonBox::rejected, this, [this] { finish(false); });
    return page;
}

void GrowPanel::make_head() {
    file_ = new QPushButton;
    file_->setObjectName("grow_file_button");
    file_->setToolTip("Chooses another file");
    steps_ = whole_number("grow_steps", 0, 1000);
    seed_ = whole_number("grow_seed", 0, most_seeds);
    limit_ = whole_number("grow_limit", 1, 10'000'000);
    limit_->setGroupSeparatorShown(true);
    limit_->setSingleStep(10'000);
    limit_->setValue(usual_limit);
    limit_->setToolTip("Growth that would pass so many nodes is refused");
    auto* another = new QPushButton("Another");
    another->setObjectName("grow_another");
    another->setToolTip("A seed by chance");
    auto* seeds = new QHBoxLayout;
    seeds->addWidget(seed_, 1);
    seeds->addWidget(another);
    beside_ = new QCheckBox("Keep what is there, and grow beside it");
    beside_->setObjectName("grow_beside");
    beside_->setChecked(model_.document().nodes.size() > 1);
    head_->addRow(form_label("File"), file_);
    head_->addRow(form_label("Steps"), steps_);
    head_->addRow(form_label("Seed"), seeds);
    head_->addRow(form_label("Nodes at most"), limit_);
    head_->addRow(beside_);
    for (QSpinBox* box : {steps_, seed_, limit_})
        connect(box, &QSpinBox::valueChanged, this, [this] { order(); });
    connect(beside_, &QCheckBox::toggled, this, [this] { order(); });
    connect(file_, &QPushButton::clicked, this, [this] { choose(); });
    connect(another, &QPushButton::clicked, this, [this] {
        std::random_device chance;
        seed_->setValue(static_cast<int>(chance() % most_seeds));
    });
}

bool GrowPanel::read(const QString& path) {
    auto text = read_file(path.toStdString());
    auto grammar = text ? parse_grammar(*text, path.toStdString()) : fail(text.error());
    if (!grammar) {
        QMessageBox box(QMessageBox::Warning, "This file cannot be grown",
                        QString::fromStdString(grammar.error().text()), QMessageBox::Ok, parentWidget());
        box.setObjectName("error");
        box.exec();
        return false;
    }
    grammar_ = std::make_shared<const Grammar>(std::move(*grammar));
    reading_ = true;
    framed_ = false;
    changed_.clear();
    file_->setText(QFileInfo(path).fileName());
    steps_->setValue(grammar_->steps);
    seed_->setValue(static_cast<int>(grammar_->seed % most_seeds));
    make_constants();
    reading_ = false;
    order();
    return true;
}

void GrowPanel::make_constants() {
    while (constants_->rowCount() > 0) constants_->removeRow(0);
    for (const GrowConstant& constant : grammar_->constants) add_constant(constant);
}

void GrowPanel::add_constant(const GrowConstant& constant) {
    const double reach = reach_of(constant.value);
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setRange(0, notches);
    slider->setValue(static_cast<int>(std::lround(notches * constant.value / reach)));
    auto* box = new NumberBox;
    box->setObjectName("grow_" + QString::fromStdString(constant.name));
    box->setRange(-1e9, 1e9);
    box->setFixedWidth(96);
    box->setValue(constant.value);
    auto* line = new QHBoxLayout;
    line->addWidget(slider, 1);
    line->addWidget(box);
    if (!constant.remark.empty()) constants_->addRow(remark_label(constant.remark));
    constants_->addRow(form_label(QString::fromStdString(constant.name)), line);
    connect(slider, &QSlider::valueChanged, box,
            [box, reach](int notch) { box->setValue(reach * notch / notches); });
    connect(box, &QDoubleSpinBox::valueChanged, this,
            [this, slider, reach, name = constant.name](double value) {
                const QSignalBlocker quiet(slider);
                slider->setValue(static_cast<int>(std::lround(notches * value / reach)));
                changed_[name] = value;
                order();
            });
}

GrowOptions GrowPanel::options() const {
    GrowOptions options{.steps = steps_->value(), .limit = limit_->value()};
    options.seed = static_cast<std::uint64_t>(seed_->value());
    options.constants.assign(changed_.begin(), changed_.end());
    return options;
}

void GrowPanel::order() {
    if (!grammar_ || reading_) return;
    accept_->setEnabled(false);  // until it is seen
    newest_ = grower_->order(grammar_, options());
}

void GrowPanel::take(const Grown& grown) {
    if (grown.order != newest_) return;
    accept_->setEnabled(grown.document.has_value());
    if (!grown.document) {
        state_->setText(QString("<span style='color:%1'>%2</span>")
                            .arg(theme::error.name(),
                                 QString::fromStdString(grown.document.error().text()).toHtmlEscaped()));
        return;
    }
    const QLocale english(QLocale::English);
    state_->setText(QString("%1 nodes, grown in %2 ms")
                        .arg(english.toString(static_cast<qlonglong>(grown.document->nodes.size())))
                        .arg(grown.ms, 0, 'f', 1));
    model_.preview(beside_->isChecked() ? added(model_.before_drag(), *grown.document) : *grown.document, {});
    if (!framed_ && first_grown) first_grown();
    framed_ = true;
}

void GrowPanel::finish(bool keep) {
    if (!grower_) return;
    grammar_.reset();  // fields that are being edited still change while they are hidden
    grower_.reset();
    keep ? model_.commit("Grow") : model_.cancel();
    hide();
    deleteLater();
    if (finished) finished();
}

void GrowPanel::closeEvent(QCloseEvent* event) {
    finish(false);
    QDockWidget::closeEvent(event);
}

void GrowPanel::keyPressEvent(QKeyEvent* event) {
    event->key() == Qt::Key_Escape ? finish(false) : QDockWidget::keyPressEvent(event);
}

}  // namespace sinew::modeler
