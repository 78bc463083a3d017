#include "evaluation/vision/marker_renderer.h"

#include "engine/vision/printed_tools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carina
{

/// Samples of a picture: what is seen, and how far away.
struct MarkerRenderer::Exposure {
    std::vector<float> grey;
    std::vector<float> depth;
};

namespace
{

constexpr double kBackground = 105.0;
constexpr double kRoom = 40.0; ///< how much lighter the background is at its right edge
constexpr std::mt19937::result_type kSampleSeed = 9;

/// The pixels that may show a face, its margin included.
struct PixelBox {
    int left = 0;
    int top = 0;
    int right = -1;
    int bottom = -1;
};

PixelBox boxOf(const CameraModel& camera, const RigidTransform& X_TK, const Vec2& half)
{
    Vec2 least = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 most = -least;
    for (int i = 0; i < 16; ++i) { // along the edges, too: they are bent
        const double u = -1.0 + 0.5 * (i % 4);
        const Vec2 edges[]{{u, 1.0}, {1.0, -u}, {-u, -1.0}, {-1.0, u}};
        const Vec2 at = half.cwiseProduct(edges[i / 4]);
        const auto pixel = project(camera, X_TK * Vec3{at.x(), at.y(), 0.0});
        if (!pixel)
            return {};
        least = least.cwiseMin(*pixel);
        most = most.cwiseMax(*pixel);
    }
    const auto within = [](double v, int size) {
        return int(std::clamp(v, -2.0, double(size) + 1.0));
    };
    return {std::max(within(least.x(), camera.width) - 2, 0),
            std::max(within(least.y(), camera.height) - 2, 0),
            std::min(within(most.x(), camera.width) + 2, camera.width - 1),
            std::min(within(most.y(), camera.height) + 2, camera.height - 1)};
}

} // namespace

MarkerRenderer::MarkerRenderer(const CameraModel& camera, MarkerDictionary dictionary,
                               const Rendering& rendering)
    : m_camera{camera}, m_dictionary{dictionary}, m_rendering{rendering}, m_random{rendering.seed}
{
    const int n = rendering.samples;
    m_sights.reserve(std::size_t(camera.width) * std::size_t(camera.height) * std::size_t(n * n));
    std::mt19937 random{kSampleSeed};
    std::uniform_real_distribution<double> share;
    for (int y = 0; y < camera.height * n; ++y)
        for (int x = 0; x < camera.width * n; ++x) {
            const double column = x + (y % n + share(random)) / n;
            const double row = y + (x % n + share(random)) / n;
            const Vec2 at{column / n - 0.5, row / n - 0.5};
            m_sights.push_back(sightOf(camera, at).head<2>().cast<float>());
        }
}

void MarkerRenderer::drawPattern(const DrawnPattern& pattern, Exposure& exposure) const
{
    const int rows = int(pattern.cells.size()) / pattern.columns;
    const Vec2 inked = 0.5 * pattern.cell * Vec2{pattern.columns, rows};
    const Vec2 half = inked + Vec2::Constant(pattern.margin);
    const Mat3 R_KT = pattern.X_TK.rotation().toRotationMatrix().transpose();
    const Vec3 p_KT = pattern.X_TK.inverse().translation();
    if (p_KT.z() <= 0.0)
        return; // it is turned away
    const Vec3 normal_T = pattern.X_TK.rotation() * Vec3::UnitZ();
    const double lit = 0.55 + 0.45 * std::abs(normal_T.dot(Vec3{0.2, 0.5, 1.0}.normalized()));
    const int n = m_rendering.samples;
    const PixelBox box = boxOf(m_camera, pattern.X_TK, half);
    for (int y = box.top * n; y < (box.bottom + 1) * n; ++y)
        for (int x = box.left * n; x < (box.right + 1) * n; ++x) {
            const auto at = std::size_t(y) * std::size_t(m_camera.width * n) + std::size_t(x);
            const Vec3 sight_K = R_KT * Vec3{m_sights[at].x(), m_sights[at].y(), -1.0};
            const double t = -p_KT.z() / sight_K.z(); // distance along -z of T
            if (!(t > 0.0) || t >= exposure.depth[at])
                continue;
            const Vec3 p_K = p_KT + t * sight_K;
            if (std::abs(p_K.x()) > half.x() || std::abs(p_K.y()) > half.y())
                continue;
            exposure.depth[at] = float(t);
            const int column = int(std::floor((p_K.x() + inked.x()) / pattern.cell));
            const int row = int(std::floor((inked.y() - p_K.y()) / pattern.cell));
            const bool isInk = column >= 0 && row >= 0 && column < pattern.columns && row < rows
                               && !pattern.cells[std::size_t(row * pattern.columns + column)];
            exposure.grey[at] = float(lit * (isInk ? m_rendering.black : m_rendering.white));
        }
}

MarkerRenderer::Exposure MarkerRenderer::emptyRoom() const
{
    Exposure exposure;
    exposure.depth.assign(m_sights.size(), std::numeric_limits<float>::infinity());
    exposure.grey.resize(m_sights.size());
    const auto width = std::size_t(m_camera.width * m_rendering.samples);
    for (std::size_t i = 0; i < m_sights.size(); ++i)
        exposure.grey[i] = float(kBackground + kRoom * double(i % width) / double(width));
    return exposure;
}

GreyPicture MarkerRenderer::draw(std::span<const PosedBody> bodies)
{
    Exposure exposure = emptyRoom();
    const int cells = cellsOf(m_dictionary);
    for (const PosedBody& placed : bodies)
        for (const BodyMarker& marker : *placed.body)
            drawPattern({cellsOf(m_dictionary, marker.id), cells, marker.side / cells,
                         placed.X_TB * marker.X_BK, kQuietZone * marker.side},
                        exposure);
    return developed(exposure.grey);
}

GreyPicture MarkerRenderer::drawBoard(const DrawnPattern& pattern)
{
    Exposure exposure = emptyRoom();
    drawPattern(pattern, exposure);
    return developed(exposure.grey);
}

/// Samples averaged to pixels, blurred, with noise.
GreyPicture MarkerRenderer::developed(const std::vector<float>& grey)
{
    const int n = m_rendering.samples;
    const int width = m_camera.width;
    const int height = m_camera.height;
    std::vector<float> sharp(std::size_t(width) * std::size_t(height));
    for (int y = 0; y < height * n; ++y)
        for (int x = 0; x < width * n; ++x)
            sharp[std::size_t(y / n) * std::size_t(width) + std::size_t(x / n)] +=
                grey[std::size_t(y) * std::size_t(width * n) + std::size_t(x)] / float(n * n);
    constexpr int kReach = 3;
    float weights[2 * kReach + 1];
    float sum = 0.0F;
    for (int i = -kReach; i <= kReach; ++i) {
        const double s = std::max(m_rendering.blur, 1e-3);
        weights[i + kReach] = float(std::exp(-0.5 * i * i / (s * s)));
        sum += weights[i + kReach];
    }
    const auto blurred = [&](const std::vector<float>& from, int dx, int dy) {
        std::vector<float> to(from.size());
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                for (int i = -kReach; i <= kReach; ++i) {
                    const int px = std::clamp(x + i * dx, 0, width - 1);
                    const int py = std::clamp(y + i * dy, 0, height - 1);
                    to[std::size_t(y) * std::size_t(width) + std::size_t(x)] +=
                        weights[i + kReach] / sum
                        * from[std::size_t(py) * std::size_t(width) + std::size_t(px)];
                }
        return to;
    };
    const std::vector<float> soft = blurred(blurred(sharp, 1, 0), 0, 1);
    GreyPicture picture{width, height, std::vector<std::uint8_t>(soft.size())};
    std::normal_distribution<float> noise{0.0F, std::max(float(m_rendering.noise), 1e-6F)};
    for (std::size_t i = 0; i < soft.size(); ++i)
        picture.pixels[i] =
            std::uint8_t(std::clamp(std::lround(soft[i] + noise(m_random)), 0L, 255L));
    return picture;
}

} // namespace carina
