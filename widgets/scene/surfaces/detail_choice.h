#pragma once

#include "engine/core/session_time.h"
#include "engine/geometry/vec.h"
#include "widgets/scene/surfaces/scene_part.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// From where a scene is seen, and how large.
struct DetailEye {
    Vec3 p_A_eye = Vec3::Zero();
    double pixelsPerTangent = 0.0; ///< what 1 m at a distance of 1 m covers
};

/// Chooses a level of detail for each part: the coarsest whose deviation from the finest is not
/// seen, and that this machine can draw in time.
///
///     error = deviation * pixelsPerTangent / distance to the nearest point of the part's sphere
///
/// must be within the tolerance, kFinestTolerance_px where time permits. The tolerance grows when
/// the mean of kFramesPerDecision frames, or of those that took the time of as many, is over
/// budget: by as much as it is, but at least by kStep and at most by kLongStep. It shrinks again
/// when the frame is then expected to take less than kComfort of the budget, by the time per
/// triangle just measured. A part becomes coarser only well within the tolerance (kCalm of it), so
/// that it does not change to and fro while a camera moves. Parts that share their level get the
/// finest that any of them needs.
class DetailChoice
{
public:
    static constexpr int kFramesPerDecision = 20;
    static constexpr double kComfort = 0.7;
    static constexpr double kCalm = 0.7;
    static constexpr double kStep = 1.4;
    static constexpr double kLongStep = 4.0;
    static constexpr double kFinestTolerance_px = 0.5;
    static constexpr double kCoarsestTolerance_px = 64.0;
    static constexpr std::size_t kFirstTriangles = 150'000; ///< at most, before a frame is measured

    /// @pre each part has a level.
    DetailChoice(std::span<const ScenePart> parts, Duration budgetPerFrame);

    /// Chooses for these parts from now on, with the tolerance that was found to do.
    void setParts(std::span<const ScenePart> parts);

    /// The level of each part, seen by these eyes; without any, those chosen last.
    const std::vector<int>& choose(std::span<const DetailEye> eyes);

    /// A level for all parts from now on, or none to choose.
    void fix(std::optional<int> level);

    /// One frame was drawn with the levels chosen last and took this long.
    void frameTook(Duration drawing);

    [[nodiscard]] const std::vector<int>& levels() const { return m_levels; }
    /// That of the parts that share theirs; of the finest part where none does.
    [[nodiscard]] int sharedLevel() const;
    /// Of all parts in their levels.
    [[nodiscard]] std::size_t triangles() const { return trianglesOf(m_levels); }
    [[nodiscard]] double tolerance_px() const { return m_tolerance_px; }

private:
    struct Part {
        Vec3 centre = Vec3::Zero();
        double radius = 0.0;
        bool sharesLevel = false;
        std::vector<double> deviations;
        std::vector<std::size_t> triangles;
    };

    [[nodiscard]] std::vector<int> levelsWithin(double tolerance_px) const;
    [[nodiscard]] int levelOf(std::size_t part, double tolerance_px) const;
    [[nodiscard]] std::size_t trianglesOf(const std::vector<int>& levels) const;
    void takeFixedLevel();
    void measureErrors(std::span<const DetailEye> eyes);
    void decide(Duration mean);

    std::vector<Part> m_parts;
    std::vector<double> m_pixelsPerMetre; ///< of each part as seen last
    std::vector<int> m_levels;
    Duration m_budget;
    std::optional<int> m_fixed;
    double m_tolerance_px = kFinestTolerance_px;
    bool m_isFirst = true;
    int m_frames = 0;
    Duration m_sum{};
};

} // namespace carina
