#include "window/reference_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QSlider>

#include "panels/number_box.h"
#include "viewport/reference_pictures.h"

namespace sinew::modeler {
namespace {

const char* const label = "Reference picture";
constexpr int first_key = 900;  ///< of edits that become one step
constexpr int longest_name = 24;

QString shown_name(const QString& file) {
    const QString name = QFileInfo(file).fileName();
    return name.size() <= longest_name ? name : name.left(longest_name - 8) + "..." + name.right(5);
}

QLabel* dim(const QString& text) {
    auto* made = new QLabel(text);
    made->setProperty("dim", true);
    return made;
}

}  // namespace

bool set_reference(Model& model, int axis, const QString& file) {
    if (read_picture(file.toStdString()).isNull()) return false;
    References references = references_of(model.document());
    references[axis].file = QFileInfo(file).absoluteFilePath().toStdString();
    model.apply(label, with_references(model.document(), references));
    return true;
}

ReferenceDialog::ReferenceDialog(Model& model, QWidget* parent) : QDialog(parent), model_(model) {
    setObjectName("reference_pictures");
    setWindowTitle("Reference pictures");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 14, 16, 14);
    column->setSpacing(12);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(8);
    const char* const heads[] = {"", "Picture", "", "Height", "Right", "Up", "Opacity"};
    for (int i = 0; i < 7; ++i) grid->addWidget(dim(heads[i]), 0, i);
    add_row(*grid, 1, "Front");
    add_row(*grid, 0, "Side");
    add_row(*grid, 2, "Top");
    column->addLayout(grid);
    column->addWidget(dim("Seen while one looks along their axis; saved with the skeleton."));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);  // Enter ends a field
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
    refresh();
}

void ReferenceDialog::add_row(QGridLayout& grid, int axis, const char* title) {
    const int row = grid.rowCount();
    Row& made = rows_[axis];
    made.choose = new QPushButton;
    made.clear = new QPushButton("Clear");
    made.choose->setObjectName(QString("choose_%1").arg(axis));
    made.clear->setObjectName(QString("clear_%1").arg(axis));
    made.choose->setMinimumWidth(180);
    for (QPushButton* button : {made.choose, made.clear}) button->setAutoDefault(false);
    made.opacity = new QSlider(Qt::Horizontal);
    made.opacity->setObjectName(QString("opacity_%1").arg(axis));
    made.opacity->setRange(5, 100);
    made.opacity->setMinimumWidth(100);
    grid.addWidget(new QLabel(title), row, 0);
    grid.addWidget(made.choose, row, 1);
    grid.addWidget(made.clear, row, 2);
    made.height = add_number(grid, axis, 3, "height", 1e-6);
    connect(made.height, &QDoubleSpinBox::valueChanged, this, [this, axis](double height) {
        change(axis, 1, [height](Reference& reference) { reference.height = height; });
    });
    made.right = add_offset(grid, axis, 4, "right", 0);
    made.up = add_offset(grid, axis, 5, "up", 1);
    grid.addWidget(made.opacity, row, 6);
    connect(made.choose, &QPushButton::clicked, this, [this, axis] { choose(axis); });
    connect(made.clear, &QPushButton::clicked, this,
            [this, axis] { change(axis, 0, [](Reference& reference) { reference = {}; }); });
    connect(made.opacity, &QSlider::valueChanged, this, [this, axis](int percent) {
        change(axis, 4, [percent](Reference& reference) { reference.opacity = percent / 100.0; });
    });
}

NumberBox* ReferenceDialog::add_number(QGridLayout& grid, int axis, int column, const char* name,
                                       double least) {
    auto* box = new NumberBox;
    box->setObjectName(QString("%1_%2").arg(name).arg(axis));
    box->setRange(least, 1e6);
    box->setMinimumWidth(80);
    if (!model_.document().unit.empty()) box->setSuffix(" " + QString::fromStdString(model_.document().unit));
    grid.addWidget(box, grid.rowCount() - 1, column);
    return box;
}

NumberBox* ReferenceDialog::add_offset(QGridLayout& grid, int axis, int column, const char* name, int part) {
    NumberBox* box = add_number(grid, axis, column, name, -1e6);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, axis, part](double offset) {
        change(axis, 2 + part, [=](Reference& reference) { reference.offset[part] = offset; });
    });
    return box;
}

void ReferenceDialog::change(int axis, int key, const std::function<void(Reference&)>& what) {
    References references = references_of(model_.document());
    what(references[axis]);
    model_.apply(label, with_references(model_.document(), references), model_.selection(),
                 key == 0 ? 0 : first_key + 10 * axis + key);
    refresh();
}

void ReferenceDialog::choose(int axis) {
    const QString now = QString::fromStdString(references_of(model_.document())[axis].file);
    QFileDialog dialog(
        this, "Choose a picture",
        now.isEmpty() ? QSettings().value("pictures/folder").toString() : QFileInfo(now).absolutePath(),
        "Pictures (*.png *.jpg *.jpeg *.svg *.bmp *.gif)");
    dialog.setObjectName("picture_dialog");
    dialog.setFileMode(QFileDialog::ExistingFile);
    if (dialog.exec() != QDialog::Accepted) return;
    const QString file = dialog.selectedFiles().value(0);
    QSettings().setValue("pictures/folder", QFileInfo(file).absolutePath());
    if (!set_reference(model_, axis, file)) {
        QMessageBox box(QMessageBox::Warning, "No picture",
                        QFileInfo(file).fileName() + " cannot be read as a picture.", QMessageBox::Ok, this);
        box.setObjectName("error");
        box.exec();
    }
    refresh();
}

void ReferenceDialog::refresh() {
    const References references = references_of(model_.document());
    for (std::size_t axis = 0; axis < rows_.size(); ++axis) {
        const Row& row = rows_[axis];
        const Reference& reference = references[axis];
        const QString file = QString::fromStdString(reference.file);
        const bool there = !file.isEmpty();
        const QSignalBlocker quiet[] = {QSignalBlocker(row.height), QSignalBlocker(row.right),
                                        QSignalBlocker(row.up), QSignalBlocker(row.opacity)};
        row.choose->setText(!there                    ? "Choose..."
                            : QFileInfo::exists(file) ? shown_name(file)
                                                      : shown_name(file) + " (not found)");
        row.choose->setToolTip(file);
        row.height->setValue(reference.height);
        row.right->setValue(reference.offset[0]);
        row.up->setValue(reference.offset[1]);
        row.opacity->setValue(static_cast<int>(std::lround(100 * reference.opacity)));
        for (QWidget* part :
             std::initializer_list<QWidget*>{row.clear, row.height, row.right, row.up, row.opacity})
            part->setEnabled(there);
    }
}

}  // namespace sinew::modeler
