/// @file file_keeper.h
/// Which file the document is in: new, open, save, recent files, and asking before something is lost.
#pragma once

#include <QString>
#include <QStringList>
#include <functional>

#include "document/model.h"
#include "files/recovery.h"

class QWidget;

namespace sinew::modeler {

class FileKeeper {
  public:
    FileKeeper(Model& model, QWidget& window);

    /// @name Each asks before it throws something away; false where the person, or an error, stopped it.
    /// @{
    bool new_document();
    bool open();
    bool open(const QString& path);
    bool may_close();
    /// @}

    bool save();
    bool save_as();
    bool save_to(const QString& path);
    bool import();
    bool import(const QString& path);

    /// Offers what a crash has left behind; true if something was recovered.
    bool offer_recovery(Recovery& recovery);

    const QString& path() const { return path_; }
    QString name() const;  ///< for the title: the file's name, or "Untitled"
    bool measured() const { return measured_; }
    const Warnings& warnings() const { return warnings_; }  ///< of the last reading
    static QStringList recent();

    std::function<void()> changed;  ///< another file, or saved
    std::function<void(const QString&)> message;

  private:
    void set_path(const QString& path, bool measured, Warnings warnings);
    bool may_replace();
    void show_error(const QString& title, const Error& error);

    Model& model_;
    QWidget& window_;
    QString path_;
    bool measured_ = false;
    Warnings warnings_;
};

}  // namespace sinew::modeler
