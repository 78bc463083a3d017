#include "widgets/scene/labels/visible_places.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace carina
{
namespace
{

constexpr int kColumns = 320;

/// The axes of a camera, in A.
struct CameraAxes {
    Vec3 forward;
    Vec3 right;
    Vec3 up;

    explicit CameraAxes(const CameraPose& pose)
        : forward{(pose.p_A_target - pose.p_A_eye).normalized()},
          right{forward.cross(pose.up_A).normalized()},
          up{right.cross(forward)}
    {
    }
};

/// A vertex as a camera sees it.
struct Projected {
    double x = 0.0; ///< fractions of the picture
    double y = 0.0;
    double depth = 0.0;
    Vec3 p_A = Vec3::Zero();
};

Projected projected(const Vec3& p_A, const CameraAxes& axes, const SceneSight& sight)
{
    const Frustum& f = sight.frustum;
    const Vec3 way = p_A - sight.pose.p_A_eye;
    const double depth = axes.forward.dot(way);
    return {(axes.right.dot(way) / depth - f.left) / (f.right - f.left),
            (f.top - axes.up.dot(way) / depth) / (f.top - f.bottom), depth, p_A};
}

/// The triangle that is the nearest in a pixel.
struct Fragment {
    double nearness = 0.0; ///< 1 / depth, 0 where there is nothing
    std::uint32_t triangle = 0;
};

/// The pixels from first to last of a span, both included.
struct PixelSpan {
    int first = std::numeric_limits<int>::max();
    int last = -1;

    void include(int i)
    {
        first = std::min(first, i);
        last = std::max(last, i);
    }
};

/// A depth buffer that knows which triangle it shows.
class Buffer
{
public:
    Buffer(int columns, int rows)
        : m_columns{columns},
          m_rows{rows},
          m_fragments(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows))
    {
    }

    [[nodiscard]] int columns() const { return m_columns; }
    [[nodiscard]] int rows() const { return m_rows; }
    /// The columns and rows that have been written to.
    [[nodiscard]] const PixelSpan& usedColumns() const { return m_usedColumns; }
    [[nodiscard]] const PixelSpan& usedRows() const { return m_usedRows; }

    [[nodiscard]] const Fragment& at(int column, int row) const
    {
        return m_fragments[indexOf(column, row)];
    }
    void set(int column, int row, const Fragment& fragment)
    {
        m_fragments[indexOf(column, row)] = fragment;
        m_usedColumns.include(column);
        m_usedRows.include(row);
    }
    void clear()
    {
        for (int row = m_usedRows.first; row <= m_usedRows.last; ++row)
            for (int column = m_usedColumns.first; column <= m_usedColumns.last; ++column)
                m_fragments[indexOf(column, row)] = {};
        m_usedColumns = {};
        m_usedRows = {};
    }

private:
    [[nodiscard]] std::size_t indexOf(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns)
               + static_cast<std::size_t>(column);
    }

    int m_columns;
    int m_rows;
    std::vector<Fragment> m_fragments;
    PixelSpan m_usedColumns;
    PixelSpan m_usedRows;
};

/// Weights of a triangle's corners at a point of the picture, for quantities that are linear there;
/// nothing outside the triangle.
std::optional<std::array<double, 3>> weightsAt(const std::array<Projected, 3>& t, double x,
                                               double y)
{
    const auto cross = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
    const double area = cross(t[1].x - t[0].x, t[1].y - t[0].y, t[2].x - t[0].x, t[2].y - t[0].y);
    if (area == 0.0)
        return std::nullopt;
    const double w0 = cross(t[1].x - x, t[1].y - y, t[2].x - x, t[2].y - y) / area;
    const double w1 = cross(t[2].x - x, t[2].y - y, t[0].x - x, t[0].y - y) / area;
    const double w2 = 1.0 - w0 - w1;
    if (w0 < 0.0 || w1 < 0.0 || w2 < 0.0)
        return std::nullopt;
    return std::array{w0, w1, w2};
}

/// The same weights for quantities that are linear in space: in the picture w / depth is.
std::array<double, 3> inSpace(const std::array<Projected, 3>& t, std::array<double, 3> weights)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += weights[i] /= t[i].depth;
    for (double& w : weights)
        w /= sum;
    return weights;
}

/// A part in its coarsest level, as a camera sees it in a frame.
class SeenPart
{
public:
    SeenPart(const ScenePart& part, const SceneFrame& frame, const CameraAxes& axes,
             const SceneSight& sight)
        : m_part{part}, m_mesh{*part.levels.back()}, m_sight{sight}
    {
        m_corners.reserve(m_mesh.positions.size());
        for (const Vec3f& p_F : m_mesh.positions) {
            const std::optional<Vec3> p_A = drawnAt(part, p_F.cast<double>(), frame);
            if (!p_A)
                return; // no corners: nothing of it is drawn
            m_corners.push_back(projected(*p_A, axes, sight));
        }
        m_isThere = true;
    }

    void drawInto(Buffer& buffer) const
    {
        for (std::uint32_t i = 0; m_isThere && i < m_mesh.triangles.size(); ++i)
            drawTriangle(buffer, i);
    }

    /// The place of a triangle that is seen in the middle of a pixel.
    [[nodiscard]] SurfacePlace placeAt(std::uint32_t triangle, double x, double y) const
    {
        const std::array<Projected, 3> t = corners(triangle);
        SurfacePlace place;
        place.weights = inSpace(t, weightsAt(t, x, y).value());
        for (std::size_t i = 0; i < 3; ++i)
            place.corners_F[i] = m_mesh.positions[m_mesh.triangles[triangle][i]].cast<double>();
        return place;
    }

private:
    [[nodiscard]] std::array<Projected, 3> corners(std::uint32_t triangle) const
    {
        const Triangle& t = m_mesh.triangles[triangle];
        return {m_corners[t[0]], m_corners[t[1]], m_corners[t[2]]};
    }

    void drawTriangle(Buffer& buffer, std::uint32_t triangle) const
    {
        const std::array<Projected, 3> t = corners(triangle);
        if (std::ranges::any_of(t, [&](const Projected& p) {
                return p.depth <= m_sight.pose.nearPlane || p.depth >= m_sight.pose.farPlane;
            }))
            return;
        const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
        const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
        const auto first = [](double share, int count) {
            return static_cast<int>(std::clamp(std::ceil(share * count - 0.5), 0.0, double(count)));
        };
        const auto last = [](double share, int count) {
            return static_cast<int>(std::clamp(std::floor(share * count - 0.5), -1.0, count - 1.0));
        };
        for (int row = first(top, buffer.rows()); row <= last(bottom, buffer.rows()); ++row)
            for (int column = first(left, buffer.columns());
                 column <= last(right, buffer.columns()); ++column)
                drawPixel(buffer, column, row, t, {0.0, triangle});
    }

    void drawPixel(Buffer& buffer, int column, int row, const std::array<Projected, 3>& t,
                   Fragment fragment) const
    {
        const auto w = weightsAt(t, (column + 0.5) / buffer.columns(), (row + 0.5) / buffer.rows());
        if (!w)
            return;
        fragment.nearness = (*w)[0] / t[0].depth + (*w)[1] / t[1].depth + (*w)[2] / t[2].depth;
        if (fragment.nearness <= buffer.at(column, row).nearness)
            return;
        const std::array<double, 3> s = inSpace(t, *w);
        if (m_sight.section
            && isCutAway(m_part, s[0] * t[0].p_A + s[1] * t[1].p_A + s[2] * t[2].p_A,
                         m_sight.section))
            return;
        buffer.set(column, row, fragment);
    }

    const ScenePart& m_part;
    const TriangleMesh& m_mesh;
    const SceneSight& m_sight;
    std::vector<Projected> m_corners;
    bool m_isThere = false;
};

/// The pixel of the buffer `own` that is visible and farthest from any that is not (chessboard
/// distance, in two sweeps: Rosenfeld and Pfaltz 1966).
std::optional<std::array<int, 2>> innermost(const Buffer& own, const Buffer& opaque)
{
    const PixelSpan& columns = own.usedColumns();
    const PixelSpan& rows = own.usedRows();
    if (rows.last < rows.first)
        return std::nullopt;
    const auto width = static_cast<std::size_t>(columns.last - columns.first + 3);
    const auto height = static_cast<std::size_t>(rows.last - rows.first + 3);
    std::vector<int> inside(width * height); // with a rim of zeros
    const auto at = [&](int column, int row) -> int& {
        return inside[static_cast<std::size_t>(row - rows.first + 1) * width
                      + static_cast<std::size_t>(column - columns.first + 1)];
    };
    for (int row = rows.first; row <= rows.last; ++row)
        for (int column = columns.first; column <= columns.last; ++column) {
            const double nearness = own.at(column, row).nearness;
            if (nearness > 0.0 && nearness >= opaque.at(column, row).nearness)
                at(column, row) = 1
                                  + std::min({at(column - 1, row), at(column - 1, row - 1),
                                              at(column, row - 1), at(column + 1, row - 1)});
        }
    std::optional<std::array<int, 2>> best;
    int most = 0;
    for (int row = rows.last; row >= rows.first; --row)
        for (int column = columns.last; column >= columns.first; --column) {
            int& here = at(column, row);
            here = std::min(here, 1
                                      + std::min({at(column + 1, row), at(column + 1, row + 1),
                                                  at(column, row + 1), at(column - 1, row + 1)}));
            if (here > most) {
                most = here;
                best = {column, row};
            }
        }
    return best;
}

int rowsFor(const Frustum& frustum)
{
    const double ratio = (frustum.top - frustum.bottom) / (frustum.right - frustum.left);
    return std::clamp(static_cast<int>(std::lround(kColumns * ratio)), 1, 4 * kColumns);
}

bool isOpaque(const ScenePart& part) { return drawLayerOf(part.group) != DrawLayer::Blended; }

/// Where the neck, or a line along which it is bent, takes a point of a body, in the frame of that
/// body.
Vec3 bentAt(const std::string& body, const Vec3& p_F, const SceneFrame& frame)
{
    if (const auto along = frame.bentAlong.find(body); along != frame.bentAlong.end())
        return along->second->taken(p_F);
    const NeckField& neck = frame.throat.neck;
    if (!neck.isBent())
        return p_F;
    if (body == frame.bends)
        return neck.placed(p_F);
    const auto inPlace = frame.bentInPlace.find(body);
    return inPlace == frame.bentInPlace.end() ? p_F : bentInBody(neck, inPlace->second, p_F);
}

} // namespace

std::optional<SeenPoint> seenPoint(const Vec3& p_A, const SceneSight& sight)
{
    const Projected seen = projected(p_A, CameraAxes{sight.pose}, sight);
    if (seen.depth < sight.pose.nearPlane || seen.x < 0.0 || seen.x > 1.0 || seen.y < 0.0
        || seen.y > 1.0)
        return std::nullopt;
    return SeenPoint{{seen.x, seen.y}, seen.depth};
}

std::optional<Vec3> drawnAt(const ScenePart& part, const Vec3& p_F, const SceneFrame& frame)
{
    Vec3 p = p_F;
    if (part.region != ChestRegion::Still)
        p += frame.chest.field.at(p, frame.chest.of(part.region)).d_A;
    const auto moved = airwayTissueOf(part.region);
    if (moved && frame.airway.isThere())
        p += airwayPull(frame.airway.frame(), *moved, p).d;
    p = bentAt(part.body, p, frame);
    const bool follows = part.body == frame.bends;
    if (const auto tissue = tissueOf(part.region); tissue && follows)
        p += throatPull(frame.throat, *tissue, p).d;
    if (moved && follows && frame.blade.isThere())
        p += bladePull(frame.blade.frame(), *moved, p).d;
    const auto place = placeOf(frame, part.body, part.liftedWith);
    return place ? std::optional{place->at(p)} : std::nullopt;
}

std::optional<Vec3> drawnAt(const ScenePart& part, const SurfacePlace& place,
                            const SceneFrame& frame)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<Vec3> corner = drawnAt(part, place.corners_F[i], frame);
        if (!corner)
            return std::nullopt;
        sum += place.weights[i] * *corner;
    }
    return sum;
}

bool isCutAway(const ScenePart& part, const Vec3& p_A, const std::optional<Section>& section)
{
    const bool whole =
        isNeverCut(part.group)
        || (section && section->cut == Cut::AllButAirway && part.group == MaterialGroup::Airway);
    return section && !whole && section->normal_A.dot(p_A) > section->distance;
}

std::vector<std::optional<SurfacePlace>> visiblePlaces(std::span<const ScenePart> shown,
                                                       std::span<const std::size_t> wanted,
                                                       const SceneFrame& frame,
                                                       const SceneSight& sight)
{
    const CameraAxes axes{sight.pose};
    const int rows = rowsFor(sight.frustum);
    Buffer opaque{kColumns, rows};
    for (const ScenePart& part : shown)
        if (isOpaque(part))
            SeenPart{part, frame, axes, sight}.drawInto(opaque);
    std::vector<std::optional<SurfacePlace>> places;
    Buffer own{kColumns, rows};
    for (const std::size_t i : wanted) {
        const SeenPart part{shown[i], frame, axes, sight};
        own.clear();
        part.drawInto(own);
        const auto pixel = innermost(own, opaque);
        places.emplace_back();
        if (pixel)
            places.back() =
                part.placeAt(own.at((*pixel)[0], (*pixel)[1]).triangle,
                             ((*pixel)[0] + 0.5) / kColumns, ((*pixel)[1] + 0.5) / rows);
    }
    return places;
}

} // namespace carina
