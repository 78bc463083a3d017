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

/// The position of an eye and the scale of its picture.
struct DetailEye {
    Vec3 p_A_eye = Vec3::Zero();
    double pixelsPerTangent = 0.0; ///< pixels covered by 1 m at a distance of 1 m
};

/// Chooses a level of detail for each part: the coarsest whose deviation from the finest is not
/// visible or, if that is too slow to draw, a coarser one.
///
///     error = deviation * pixelsPerTangent / distance to the nearest point of the part's sphere
///
/// must not exceed the tolerance, which is kFinestTolerance_px if time permits. Every
/// kFramesPerDecision frames, or earlier if their total exceeds the budget of that many, the mean
/// drawing time is compared with the budget. If it is larger, the tolerance is multiplied by their
/// ratio, limited to kStep..kLongStep. The tolerance is divided by kStep if the time then expected,
/// from the measured time per triangle, is below kComfort of the budget. A part becomes coarser
/// only at an error below kCalm of the tolerance, so that it does not switch back and forth while a
/// camera moves. Parts that share their level get the finest that any of them needs.
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
    static constexpr std::size_t kFirstTriangles = 150'000; ///< limit before a frame was measured

    /// @pre each part has a level.
    DetailChoice(std::span<const ScenePart> parts, Duration budgetPerFrame);

    /// Replaces the parts, and keeps the tolerance reached so far.
    void setParts(std::span<const ScenePart> parts);

    /// Chooses the level of each part for these eyes; without eyes, returns those chosen last.
    /// @param isResting this once, as if time permitted what cannot be seen to be coarser
    const std::vector<int>& choose(std::span<const DetailEye> eyes, bool isResting = false);

    /// Fixes the level of all parts; std::nullopt chooses automatically again.
    void fix(std::optional<int> level);
    [[nodiscard]] bool isFixed() const { return m_fixed.has_value(); }
    /// Whether time permits levels that cannot be seen to be coarser; also where they are fixed.
    [[nodiscard]] bool isFinest() const
    {
        return isFixed() || (!m_isFirst && m_tolerance_px <= kFinestTolerance_px);
    }

    /// From now on. @pre above 0
    void setBudget(Duration perFrame) { m_budget = perFrame; }

    /// Records the drawing time of a frame with the levels chosen last.
    void frameTook(Duration drawing);

    [[nodiscard]] const std::vector<int>& levels() const { return m_levels; }
    /// The common level of the parts that share theirs; the finest level in use if no part does.
    [[nodiscard]] int sharedLevel() const;
    /// The number of triangles of all parts in their levels.
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
    std::vector<double> m_pixelsPerMetre; ///< of each part, for the latest eyes
    std::vector<int> m_levels;
    Duration m_budget;
    std::optional<int> m_fixed;
    double m_tolerance_px = kFinestTolerance_px;
    bool m_isFirst = true;
    int m_frames = 0;
    Duration m_sum{};
};

} // namespace carina
