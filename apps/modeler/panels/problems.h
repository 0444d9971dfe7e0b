/// @file problems.h
/// What is wrong, or was repaired: of the document, of reading it and of skinning it. A click selects the
/// node.
#pragma once

#include <QListWidget>
#include <memory>

#include "document/model.h"
#include "live/pipeline.h"

namespace sinew::modeler {

class Problems : public QListWidget {
  public:
    explicit Problems(Model& model, QWidget* parent = nullptr);
    void show_mesh(const std::shared_ptr<const LiveMesh>& mesh);
    void show_reading(const Warnings& warnings);
    std::function<void(int)> counted;  ///< how many there are

  private:
    enum class Weight : std::uint8_t { error, warning };
    void refresh();
    void add(Weight weight, const std::string& text, const std::vector<std::int64_t>& ids);

    Model& model_;
    std::shared_ptr<const LiveMesh> mesh_;
    Warnings reading_;
};

}  // namespace sinew::modeler
