/// @file few_colours.h
/// Pictures for the handbook: 256 colours make a PNG a third as large, and a window has few.
#pragma once

#include <QImage>
#include <algorithm>
#include <vector>

namespace sinew::modeler {

/// Adds the mean colours of the fullest cells of colours that share their upper bits, until there are `most`.
inline void add_fullest(const QImage& image, int bits, qsizetype most, QList<QRgb>& colours) {
    struct Cell {
        std::int64_t count = 0, red = 0, green = 0, blue = 0;
    };
    std::vector<Cell> cells(std::size_t{1} << (3 * bits));
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QRgb c = image.pixel(x, y);
            const int cut = 8 - bits;
            Cell& cell = cells[((qRed(c) >> cut) << bits | qGreen(c) >> cut) << bits | qBlue(c) >> cut];
            cell.count += 1;
            cell.red += qRed(c);
            cell.green += qGreen(c);
            cell.blue += qBlue(c);
        }
    std::stable_sort(cells.begin(), cells.end(),
                     [](const Cell& a, const Cell& b) { return a.count > b.count; });
    for (const Cell& cell : cells) {
        if (cell.count == 0 || colours.size() == most) return;
        const auto mean = [&](std::int64_t sum) { return static_cast<int>(sum / cell.count); };
        colours.append(qRgb(mean(cell.red), mean(cell.green), mean(cell.blue)));
    }
}

/// Some of every hue, so that nothing small turns grey; what is left for the gradients.
inline QImage in_few_colours(const QImage& image) {
    QList<QRgb> colours;
    add_fullest(image, 3, 120, colours);
    add_fullest(image, 5, 256, colours);
    return image.convertToFormat(QImage::Format_Indexed8, colours);
}

}  // namespace sinew::modeler
