#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// Upper and lower lip, which meet at the corners of the mouth. The upper one has a cupid's bow and
/// the end of the philtrum. Frame A, metres; signed distances, both sides alike. How thick and how
/// curved they are is of ours.
///
/// A jaw takes the lower lip along. Where it holds the mouth open, the corners are midway between
/// their places with the mouth closed and on the jaw, and each lip goes on beyond the corner, the
/// upper one down and the lower one up: so they stay together where a laryngoscopy opens it
/// farther.
class Lips
{
public:
    explicit Lips(const BodyPlan& plan);

    [[nodiscard]] double upper(const Vec3& p_A) const;
    [[nodiscard]] double lower(const Vec3& p_A) const;

    /// The left corner of the mouth.
    [[nodiscard]] const Vec3& p_A_corner() const { return m_p_A_corner; }

    /// As parts.
    [[nodiscard]] std::vector<PartPlan> parts() const;

private:
    /// A round rod along a line from the midline to the left.
    struct Rod {
        std::vector<Vec3> line_A;
        std::vector<double> radii;

        [[nodiscard]] double distance(const Vec3& p_A) const;
        [[nodiscard]] Box bounds() const;
    };

    Vec3 m_p_A_incisors;
    Vec3 m_p_A_corner;
    double m_unit; ///< metres per reference millimetre of the face
    Rod m_upper;
    Rod m_lower;
};

} // namespace carina
