#include "models/station/sent_shape.h"

#include "engine/airway/tube/tube_in_lumen.h"

namespace carina
{

StreamShape toStream(const TubeForm& form, SessionTime t)
{
    return {t, form.length.si, form.entry.si, form.plane.si, form.perMetre};
}

TubeForm fromStream(const StreamShape& shape)
{
    return {metres(shape.length), metres(shape.entry), radians(shape.plane), shape.perMetre};
}

std::vector<Vec3> lineOf(const ShapeBetween& shape)
{
    constexpr int kPieces = TubeInLumen::kPieces;
    const std::vector<Vec3> from = lineOf(fromStream(shape.from), kPieces);
    std::vector<Vec3> line = lineOf(fromStream(shape.to), kPieces);
    for (std::size_t i = 0; i < line.size(); ++i)
        line[i] = from[i] + shape.times * (line[i] - from[i]);
    return line;
}

} // namespace carina
