#include "window/dialogs.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

#include "window/icons.h"

namespace sinew::modeler {

std::optional<Symmetry> ask_radial_symmetry(QWidget* parent, const Symmetry& now) {
    QDialog dialog(parent);
    dialog.setObjectName("radial_symmetry");
    dialog.setWindowTitle("Radial symmetry");
    auto* form = new QFormLayout(&dialog);
    auto* axis = new QComboBox;
    axis->addItems({"X", "Y", "Z"});
    auto* count = new QSpinBox;
    count->setRange(2, 1000);
    const bool radial = now.kind == Symmetry::Kind::radial;
    axis->setCurrentIndex(radial ? now.axis : 2);
    count->setValue(radial ? now.count : 6);
    form->addRow("Axis", axis);
    form->addRow("Images", count);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    form->addRow(buttons);
    count->setFocus();
    count->selectAll();
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    return Symmetry{Symmetry::Kind::radial, axis->currentIndex(), count->value()};
}

namespace {

/// The row of one picture: choose, clear, height, opacity.
void add_picture(QGridLayout& grid, const QString& title, ReferencePicture& picture,
                 const std::function<void()>& changed) {
    const int row = grid.rowCount();
    auto* choose = new QPushButton(picture.file.isEmpty() ? "Choose..." : QFileInfo(picture.file).fileName());
    auto* clear = new QPushButton("Clear");
    auto* height = new QDoubleSpinBox;
    height->setRange(0.001, 1e6);
    height->setDecimals(3);
    height->setValue(picture.height);
    auto* opacity = new QSlider(Qt::Horizontal);
    opacity->setRange(5, 100);
    opacity->setValue(static_cast<int>(100 * picture.opacity));
    opacity->setMinimumWidth(110);
    grid.addWidget(new QLabel(title), row, 0);
    grid.addWidget(choose, row, 1);
    grid.addWidget(clear, row, 2);
    grid.addWidget(height, row, 3);
    grid.addWidget(opacity, row, 4);
    QObject::connect(choose, &QPushButton::clicked, choose, [=, &picture] {
        const QString file = QFileDialog::getOpenFileName(choose, "Choose a picture", picture.file,
                                                          "Pictures (*.png *.jpg *.jpeg *.svg *.bmp *.gif)");
        if (file.isEmpty()) return;
        if (!picture.load(file))
            QMessageBox::warning(choose, "No picture", file + " cannot be read as a picture.");
        choose->setText(picture.file.isEmpty() ? "Choose..." : QFileInfo(picture.file).fileName());
        changed();
    });
    QObject::connect(clear, &QPushButton::clicked, choose, [=, &picture] {
        picture.image = {};
        picture.file.clear();
        choose->setText("Choose...");
        changed();
    });
    QObject::connect(height, &QDoubleSpinBox::valueChanged, choose, [=, &picture](double value) {
        picture.height = value;
        changed();
    });
    QObject::connect(opacity, &QSlider::valueChanged, choose, [=, &picture](int value) {
        picture.opacity = value / 100.0;
        changed();
    });
}

}  // namespace

void ask_reference_pictures(QWidget* parent, ReferencePictures& pictures,
                            const std::function<void()>& changed) {
    QDialog dialog(parent);
    dialog.setObjectName("reference_pictures");
    dialog.setWindowTitle("Reference pictures");
    auto* column = new QVBoxLayout(&dialog);
    auto* grid = new QGridLayout;
    grid->addWidget(new QLabel("Height"), 0, 3);
    grid->addWidget(new QLabel("Opacity"), 0, 4);
    add_picture(*grid, "Front", pictures[1], changed);
    add_picture(*grid, "Side", pictures[0], changed);
    add_picture(*grid, "Top", pictures[2], changed);
    column->addLayout(grid);
    auto* note =
        new QLabel("They are shown while one looks along their axis, and are not part of the document.");
    note->setStyleSheet("color: #98a0ad");
    column->addWidget(note);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    column->addWidget(buttons);
    dialog.exec();
}

void show_about(QWidget* parent) {
    QMessageBox box(parent);
    box.setObjectName("about");
    box.setWindowTitle("About");
    box.setIconPixmap(icon("sinew-modeler").pixmap(72, 72));
    box.setText(QString("<h3>Skeleton Modeler %1</h3>Skeleton in, clean quads out.<br>Part of Sinew, under "
                        "the MIT licence.")
                    .arg(SINEW_VERSION));
    box.exec();
}

}  // namespace sinew::modeler
