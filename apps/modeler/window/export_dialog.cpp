#include "window/export_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTimer>
#include <thread>

#include "document/view_settings.h"
#include "panels/number_box.h"
#include "sinew/io/formats.h"

namespace sinew::modeler {
namespace {

QString qt_text(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

struct Wish {
    QString path;
    MeshOptions mesh;
    MeshWriteOptions write;
};

/// How long a unit of the document is, as far as its name tells.
double metres_in(const std::string& unit) {
    constexpr std::pair<const char*, double> known[] = {{"m", 1},     {"cm", 0.01}, {"mm", 0.001},
                                                        {"um", 1e-6}, {"nm", 1e-9}, {"km", 1000}};
    for (const auto& [name, metres] : known)
        if (unit == name) return metres;
    return 1;
}

class ExportDialog : public QDialog {
  public:
    ExportDialog(QWidget* parent, const Document& document, const MeshOptions& start, const QString& beside);
    Wish wish() const;

  private:
    const Format& format() const { return *choices_[format_->currentIndex()]; }
    void follow_format();

    std::vector<const Format*> choices_;
    QComboBox* format_ = new QComboBox;
    QLineEdit* path_ = new QLineEdit;
    QSpinBox* level_ = new QSpinBox;
    QSpinBox* sides_ = new QSpinBox;
    QCheckBox* limit_ = new QCheckBox("Radii are those of the subdivided surface");
    QCheckBox* text_ = new QCheckBox("As text, not binary");
    NumberBox* metres_ = new NumberBox;
    QLabel* note_ = new QLabel;
    bool repair_;
};

ExportDialog::ExportDialog(QWidget* parent, const Document& document, const MeshOptions& start,
                           const QString& beside)
    : QDialog(parent), repair_(start.repair) {
    setObjectName("export_dialog");
    setWindowTitle("Export mesh");
    for (const Format& format : formats()) {
        if (!format.writes_mesh) continue;
        choices_.push_back(&format);
        format_->addItem(QString("%1  (%2)").arg(qt_text(format.about), qt_text(format.extension)));
    }
    format_->setObjectName("export_format");
    path_->setObjectName("export_path");
    path_->setMinimumWidth(340);
    level_->setObjectName("export_level");
    level_->setRange(0, most_levels);
    level_->setValue(start.level);
    sides_->setRange(0, 64);
    sides_->setSpecialValueText("as few as possible");
    sides_->setValue(start.sides);
    limit_->setChecked(start.to_limit);
    text_->setObjectName("export_text");
    metres_->setRange(1e-9, 1e6);
    metres_->setValue(metres_in(document.unit));
    metres_->setSuffix(" m");
    note_->setProperty("dim", true);

    auto* form = new QFormLayout(this);
    form->setContentsMargins(16, 14, 16, 14);
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(8);
    form->addRow(form_label("Format"), format_);
    auto* file = new QHBoxLayout;
    file->setSpacing(8);
    auto* browse = new QPushButton("Browse...");
    file->addWidget(path_);
    file->addWidget(browse);
    form->addRow(form_label("File"), file);
    form->addRow(form_label("Subdivision"), level_);
    form->addRow("", limit_);
    form->addRow(form_label("Sides of a tube"), sides_);
    form->addRow(form_label("One unit is"), metres_);
    form->addRow("", text_);
    form->addRow("", note_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText("Export");
    form->addRow(buttons);
    path_->setText(QSettings().value("export/folder", QFileInfo(beside).absolutePath()).toString() + "/" +
                   (beside.isEmpty() ? "untitled" : QFileInfo(beside).completeBaseName()));
    format_->setCurrentIndex(
        std::clamp(QSettings().value("export/format", 0).toInt(), 0, format_->count() - 1));
    follow_format();
    path_->setFocus();
    path_->selectAll();
    connect(format_, &QComboBox::currentIndexChanged, this, [this] { follow_format(); });
    connect(level_, &QSpinBox::valueChanged, this, [this] { follow_format(); });
    connect(browse, &QPushButton::clicked, this, [this] {
        const QString chosen = QFileDialog::getSaveFileName(this, "Export to", path_->text());
        if (!chosen.isEmpty()) path_->setText(chosen);
    });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ExportDialog::follow_format() {
    const QFileInfo file(path_->text());
    path_->setText(file.path() + "/" + file.completeBaseName() + qt_text(format().extension));
    QStringList notes;
    if (!format().carries.quads) notes << "Quads are split into triangles";
    if (!format().carries.creases && level_->value() == 0) notes << "Creases are not kept";
    note_->setText(notes.join(". "));
    metres_->setEnabled(format().carries.units);
    limit_->setEnabled(level_->value() > 0);
    text_->setEnabled(format().name == "ply");
}

Wish ExportDialog::wish() const {
    Wish wish;
    wish.path = path_->text();
    wish.mesh = {level_->value(), limit_->isChecked(), sides_->value(), repair_};
    wish.write.format = std::string(format().name);
    wish.write.metres_a_unit = metres_->value();
    wish.write.ascii = text_->isEnabled() && text_->isChecked();
    QSettings().setValue("export/folder", QFileInfo(wish.path).absolutePath());
    QSettings().setValue("export/format", format_->currentIndex());
    return wish;
}

/// Makes and writes the mesh on another thread; the bar's button stops it.
Result<void> run(QWidget* parent, const Document& document, const Wish& wish) {
    std::atomic<bool> stop{false}, done{false};
    std::atomic<double> share{0};
    Result<void> outcome;
    std::thread worker([&] {
        const Progress progress([&](double s, std::string_view) { share = s; }, &stop);
        const LiveMesh made = Pipeline().run(document, wish.mesh, progress, false);
        outcome =
            made.error ? fail(*made.error) : write_mesh(*made.mesh, wish.path.toStdString(), wish.write);
        done = true;
    });
    QProgressDialog bar("Making the mesh...", "Stop", 0, 100, parent);
    bar.setWindowModality(Qt::WindowModal);
    bar.setMinimumDuration(400);
    QEventLoop loop;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &loop, [&] {
        stop = stop || bar.wasCanceled();
        if (done) return loop.quit();
        bar.setValue(std::min(99, static_cast<int>(100 * share)));
    });
    timer.start(15);
    loop.exec();
    worker.join();
    return outcome;
}

}  // namespace

QString export_mesh(QWidget* parent, const Document& document, const MeshOptions& start,
                    const QString& beside) {
    ExportDialog dialog(parent, document, start, beside);
    if (dialog.exec() != QDialog::Accepted) return {};
    const Wish wish = dialog.wish();
    const Result<void> outcome = run(parent, document, wish);
    if (outcome) return wish.path;
    if (outcome.error().kind != ErrorKind::cancelled)
        QMessageBox::warning(parent, "The mesh was not exported", qt_text(outcome.error().text()));
    return {};
}

}  // namespace sinew::modeler
