#include "look/icons.h"

#include <QFile>
#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QSvgRenderer>

#include "look/theme.h"

namespace sinew::modeler {
namespace {

/// Draws the SVG afresh for each size, so that it is sharp on every screen; grey where it is disabled.
class SvgEngine : public QIconEngine {
  public:
    explicit SvgEngine(QByteArray source) : source_(std::move(source)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        const QColor colour = mode == QIcon::Disabled ? QColor(0x6a, 0x71, 0x7c) : theme::text;
        QByteArray text = source_;
        text.replace("currentColor", colour.name().toLatin1());
        QSvgRenderer renderer(text);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        if (mode == QIcon::Disabled) painter->setOpacity(0.6);
        renderer.render(painter, rect);
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }
    QIconEngine* clone() const override { return new SvgEngine(source_); }

  private:
    QByteArray source_;
};

const char* const type_names[] = {"type.sphere", "type.cone",     "type.hemisphere",
                                  "type.cube",   "type.negative", "type.ball"};

}  // namespace

QIcon icon(const QString& name) {
    static QHash<QString, QIcon> known;
    const auto found = known.constFind(name);
    if (found != known.constEnd()) return *found;
    QFile file(":/icons/" + name + ".svg");
    const QIcon made = file.open(QIODevice::ReadOnly) ? QIcon(new SvgEngine(file.readAll())) : QIcon();
    known.insert(name, made);
    return made;
}

QIcon icon_of(const Node& node) {
    if (node.parent < 0 && node.type == NodeType::sphere) return icon("type.root");
    return icon(type_names[static_cast<int>(node.type)]);
}

}  // namespace sinew::modeler
