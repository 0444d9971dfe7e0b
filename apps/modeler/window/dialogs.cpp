#include "window/dialogs.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QMessageBox>
#include <QSpinBox>

#include "look/icons.h"

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
