#include "models/station/tube_drawing.h"

#include <QCoreApplication>

namespace carina
{

QString drawingText(TubeDrawing drawing)
{
    const auto words = [](const char* text) {
        return QCoreApplication::translate("TubeDrawing", text);
    };
    switch (drawing) {
    case TubeDrawing::Awaited:
        return words(QT_TRANSLATE_NOOP(
            "TubeDrawing", "The airway is being measured for this tube: until then it is drawn as "
                           "it was tracked, and does not bend"));
    case TubeDrawing::NoLumen:
        return words(QT_TRANSLATE_NOOP(
            "TubeDrawing", "The airway of this patient cannot be measured: the tube is drawn as it "
                           "was tracked, and does not bend"));
    case TubeDrawing::Apart:
        return words(QT_TRANSLATE_NOOP(
            "TubeDrawing", "The tracked tube lies more than 5\u00a0mm beside the virtual one: no "
                           "depth is told. The outline shows where it was measured"));
    case TubeDrawing::AsMeasured:
    case TubeDrawing::InAirway:
        break;
    }
    return {};
}

} // namespace carina
