#include "window/file_keeper.h"

#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>

#include "document/edits.h"
#include "document/references.h"
#include "files/load.h"
#include "sinew/io/formats.h"
#include "sinew/io/skeleton_formats.h"

namespace sinew::modeler {
namespace {

constexpr int most_recent = 10;

QString to_qt(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// "Skeletons (*.sinew *.graph ...);;..." for a file dialog.
QString filters(bool for_reading) {
    QStringList patterns, lines;
    for (const Format& format : formats()) {
        if (!(for_reading ? format.reads_skeleton : format.writes_skeleton)) continue;
        const QString pattern = "*" + to_qt(format.extension);
        patterns << pattern;
        lines << QString("%1 (%2)").arg(to_qt(format.about), pattern);
    }
    if (for_reading) lines.prepend(QString("Skeletons (%1)").arg(patterns.join(' ')));
    return lines.join(";;");
}

void remember(const QString& path) {
    QStringList recent = FileKeeper::recent();
    recent.removeAll(path);
    recent.prepend(path);
    QSettings().setValue("recent", recent.mid(0, most_recent));
}

/// What cannot be opened any more is not offered again.
void forget(const QString& path) {
    QStringList recent = FileKeeper::recent();
    recent.removeAll(QFileInfo(path).absoluteFilePath());
    QSettings().setValue("recent", recent);
}

std::string folder_of(const QString& path) { return QFileInfo(path).absolutePath().toStdString(); }

QString ask_path(QWidget& window, const QString& title, QFileDialog::AcceptMode mode, const QString& start) {
    const QString home = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString folder =
        start.contains('/') ? QFileInfo(start).absolutePath() : QSettings().value("folder", home).toString();
    QFileDialog dialog(&window, title, folder, filters(mode == QFileDialog::AcceptOpen));
    dialog.setObjectName(mode == QFileDialog::AcceptOpen ? "open_dialog" : "save_dialog");
    dialog.setAcceptMode(mode);
    dialog.setFileMode(mode == QFileDialog::AcceptOpen ? QFileDialog::ExistingFile : QFileDialog::AnyFile);
    if (mode == QFileDialog::AcceptSave) {
        dialog.setDefaultSuffix("sinew");
        dialog.selectFile(QFileInfo(start).fileName());
    }
    if (dialog.exec() != QDialog::Accepted) return {};
    const QString path = dialog.selectedFiles().value(0);
    QSettings().setValue("folder", QFileInfo(path).absolutePath());
    return path;
}

}  // namespace

FileKeeper::FileKeeper(Model& model, QWidget& window) : model_(model), window_(window) {}

QStringList FileKeeper::recent() { return QSettings().value("recent").toStringList(); }

QString FileKeeper::name() const { return path_.isEmpty() ? "Untitled" : QFileInfo(path_).fileName(); }

void FileKeeper::set_path(const QString& path, bool measured, Warnings warnings) {
    path_ = path;
    measured_ = measured;
    warnings_ = std::move(warnings);
    if (!path.isEmpty()) remember(QFileInfo(path).absoluteFilePath());
    if (changed) changed();
}

void FileKeeper::show_error(const QString& title, const Error& error) {
    QMessageBox box(QMessageBox::Warning, title, to_qt(error.text()), QMessageBox::Ok, &window_);
    box.setObjectName("error");
    box.exec();
}

bool FileKeeper::may_replace() {
    if (model_.previewing()) model_.cancel();
    if (!model_.modified()) return true;
    QMessageBox box(QMessageBox::Question, "Save changes?",
                    QString("<b>%1</b> has changes that are not saved.").arg(name().toHtmlEscaped()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window_);
    box.setObjectName("ask_to_save");
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
        case QMessageBox::Save:
            return save();
        case QMessageBox::Discard:
            return true;
        default:
            return false;
    }
}

bool FileKeeper::may_close() { return may_replace(); }

bool FileKeeper::new_document() {
    if (!may_replace()) return false;
    model_.replace(starting_document(), true);
    model_.select(selection_of(0));
    set_path({}, false, {});
    return true;
}

bool FileKeeper::open() {
    const QString path = ask_path(window_, "Open a skeleton", QFileDialog::AcceptOpen, path_);
    return !path.isEmpty() && open(path);
}

bool FileKeeper::open(const QString& path) {
    // What cannot be opened is no reason to ask what is to become of what is open.
    auto read = load(path.toStdString());
    if (!read) {
        forget(path);
        show_error("This file cannot be opened", read.error());
        return false;
    }
    if (!may_replace()) return false;
    model_.replace(std::move(read->document), true);
    set_path(path, read->measured, std::move(read->warnings));
    return true;
}

bool FileKeeper::save() {
    const bool native = path_.endsWith(".sinew", Qt::CaseInsensitive);
    return native ? save_to(path_) : save_as();
}

bool FileKeeper::save_as() {
    const QString start =
        path_.isEmpty() ? "untitled.sinew"
                        : QFileInfo(path_).path() + "/" + QFileInfo(path_).completeBaseName() + ".sinew";
    const QString path = ask_path(window_, "Save the skeleton", QFileDialog::AcceptSave, start);
    return !path.isEmpty() && save_to(path);
}

bool FileKeeper::save_to(const QString& path) {
    auto written =
        write_skeleton(with_relative_files(model_.document(), folder_of(path)), path.toStdString());
    if (!written) {
        show_error("The skeleton was not saved", written.error());
        return false;
    }
    model_.mark_saved();
    set_path(path, measured_, std::move(*written));
    if (message) message("Saved " + QFileInfo(path).fileName());
    return true;
}

bool FileKeeper::import() {
    const QString path = ask_path(window_, "Add a skeleton", QFileDialog::AcceptOpen, path_);
    return !path.isEmpty() && import(path);
}

bool FileKeeper::import(const QString& path) {
    auto read = load(path.toStdString());
    if (!read) {
        show_error("This file cannot be imported", read.error());
        return false;
    }
    const auto first = static_cast<std::int32_t>(model_.document().nodes.size());
    Document next = added(model_.document(), read->document);
    Selection fresh;
    for (std::int32_t i = first; i < std::ssize(next.nodes); ++i) fresh.nodes.push_back(i);
    if (!fresh.empty()) fresh.active = fresh.nodes.front();
    model_.apply("Import", std::move(next), std::move(fresh));
    measured_ = measured_ || read->measured;
    warnings_ = std::move(read->warnings);
    if (changed) changed();
    return true;
}

bool FileKeeper::offer_recovery(Recovery& recovery) {
    const std::vector<Leftover> leftovers = recovery.leftovers();
    if (leftovers.empty()) return false;
    const Leftover& last = leftovers.front();
    const QString original = to_qt(last.original);
    QMessageBox box(QMessageBox::Question, "Recover unsaved work?",
                    QString("The modeler did not close as it should. Changes to <b>%1</b> that were not "
                            "saved can be recovered.")
                        .arg((original.isEmpty() ? "an untitled skeleton" : QFileInfo(original).fileName())
                                 .toHtmlEscaped()),
                    QMessageBox::NoButton, &window_);
    box.setObjectName("recover");
    QPushButton* recover = box.addButton("Recover", QMessageBox::AcceptRole);
    QPushButton* discard = box.addButton("Discard", QMessageBox::DestructiveRole);
    box.setDefaultButton(recover);
    box.exec();
    if (box.clickedButton() == discard)
        for (const Leftover& leftover : leftovers) Recovery::discard(leftover);
    if (box.clickedButton() != recover) return false;
    auto read = load(last.copy.string());
    if (!read) {
        show_error("The copy cannot be read", read.error());
        return false;
    }
    model_.replace(std::move(read->document), false);
    set_path(original, false, std::move(read->warnings));
    if (recovery.keep(model_.document(), last.original)) Recovery::discard(last);
    return true;
}

}  // namespace sinew::modeler
