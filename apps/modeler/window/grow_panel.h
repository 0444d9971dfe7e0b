/// @file grow_panel.h
/// Grow from L-system: fields for the constants, steps and seed of a .lsys file; the skeleton changes in the
/// viewport while one turns them.
#pragma once

#include <QDockWidget>
#include <functional>
#include <map>
#include <memory>

#include "document/model.h"
#include "live/grower.h"

class QCheckBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSpinBox;

namespace sinew::modeler {

/// Previews in the model while it is open; kept it leaves one undo step, closed it leaves all as it was.
/// Nothing else may edit the model meanwhile (see MainWindow::lock).
class GrowPanel : public QDockWidget {
  public:
    GrowPanel(Model& model, QWidget* parent);

    /// @return false, after an error was shown, where the file is no L-system
    bool read(const QString& path);

    std::function<void()> first_grown;  ///< the first preview of a file is there
    std::function<void()> choose;       ///< the person wants another file
    std::function<void()> finished;     ///< it is over; the panel goes by itself

    void finish(bool keep);

  protected:
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QWidget* make_page();
    void make_head();
    void make_constants();
    void add_constant(const GrowConstant& constant);
    void order();
    void take(const Grown& grown);
    GrowOptions options() const;

    Model& model_;
    std::shared_ptr<const Grammar> grammar_;
    std::map<std::string, double> changed_;  ///< constants that the person has set
    std::uint64_t newest_ = 0;
    bool framed_ = false, reading_ = false;
    QPushButton* file_ = nullptr;
    QSpinBox *steps_ = nullptr, *seed_ = nullptr, *limit_ = nullptr;
    QCheckBox* beside_ = nullptr;
    QFormLayout *head_ = nullptr, *constants_ = nullptr;
    QLabel* state_ = nullptr;
    QPushButton* accept_ = nullptr;
    std::unique_ptr<Grower> grower_;
};

}  // namespace sinew::modeler
