#include "engine/registration/landmarks/touch_recognition.h"

#include "engine/core/expects.h"
#include "engine/geometry/fit/point_check.h"
#include "engine/registration/error/error_bound.h"
#include "engine/registration/fit/manikin_scale.h"
#include "engine/registration/fit/pose_misfit.h"
#include "engine/registration/landmarks/landmark_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carina
{
namespace
{

double plausibleChiSquared(double degrees)
{
    return degrees > 0.0 ? degrees * chiSquaredShare(degrees, kPlausibleShare) : 0.0;
}

/// An assignment of touches: pairs of a landmark's position and its touch, and the landmarks'
/// indices.
struct Named {
    std::vector<LandmarkPair> pairs{};
    std::vector<std::size_t> landmarks{};

    [[nodiscard]] Named without(std::size_t landmark) const
    {
        Named others;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            if (landmarks[i] != landmark)
                others.add(landmarks[i], pairs[i]);
        }
        return others;
    }
    void add(std::size_t landmark, const LandmarkPair& pair)
    {
        pairs.push_back(pair);
        landmarks.push_back(landmark);
    }
    [[nodiscard]] double misfitWith(const LandmarkPair& another) const
    {
        std::vector<LandmarkPair> all = pairs;
        all.push_back(another);
        return poseMisfit(all);
    }
    /// The number of coordinates by which they constrain a further point.
    [[nodiscard]] double hold() const
    {
        return pairs.size() >= 3 && fitRigid(pairs) ? 3.0 : std::min(2.0, double(pairs.size()));
    }
};

/// One landmark that a touch may be.
struct Guess {
    std::size_t landmark = 0;
    double chiSquared = 0.0;
    bool isPlausible = false;
};

class Recognition
{
public:
    Recognition(const TouchesSoFar& earlier, const Vec3& p_TQ, Length fle)
        : m_earlier{earlier}, m_p_TQ{p_TQ}, m_variance{fle.si * fle.si / 3.0}
    {
        for (std::size_t i = 0; i < earlier.p_AQ.size(); ++i) {
            if (earlier.p_TQ[i])
                m_named.add(i, {earlier.p_AQ[i], *earlier.p_TQ[i]});
        }
    }

    [[nodiscard]] TouchFinding finding(std::optional<std::size_t> proposed) const
    {
        std::vector<Guess> guesses;
        for (std::size_t i = 0; i < m_earlier.p_AQ.size(); ++i)
            guesses.push_back(m_earlier.p_TQ[i] ? again(i) : open(i));
        if (m_named.hold() < 3.0 && proposed && guesses[*proposed].isPlausible)
            return asLandmark(guesses[*proposed]);
        std::ranges::stable_sort(guesses, {}, &Guess::chiSquared);
        if (!agrees(guesses.front())) {
            if (auto renamed = anotherNaming())
                return *renamed;
        }
        if (!guesses.front().isPlausible) {
            TouchFinding nowhere = asLandmark(guesses.front());
            nowhere.verdict = TouchVerdict::Nowhere;
            return nowhere;
        }
        const double limit = guesses.front().chiSquared + kClearLead;
        TouchFinding finding = asLandmark(guesses.front());
        for (const Guess& guess : guesses) {
            if (guess.chiSquared <= limit)
                finding.candidates.push_back(guess.landmark);
        }
        if (finding.candidates.size() > 1)
            finding.verdict = TouchVerdict::Ambiguous;
        else
            finding.candidates.clear();
        return finding;
    }

private:
    [[nodiscard]] Guess judged(std::size_t landmark, double square, double degrees) const
    {
        const double chiSquared = std::max(0.0, square) / m_variance;
        return {landmark, chiSquared, chiSquared <= plausibleChiSquared(degrees)};
    }

    [[nodiscard]] Guess open(std::size_t landmark) const
    {
        const double square =
            m_named.misfitWith({m_earlier.p_AQ[landmark], m_p_TQ}) - poseMisfit(m_named.pairs);
        return judged(landmark, square, m_named.hold());
    }

    [[nodiscard]] Guess again(std::size_t landmark) const
    {
        const double apart = 0.5 * (m_p_TQ - *m_earlier.p_TQ[landmark]).squaredNorm();
        const Named others = m_named.without(landmark);
        if (others.hold() < 3.0)
            return judged(landmark, apart, 3.0);
        const double square =
            others.misfitWith({m_earlier.p_AQ[landmark], m_p_TQ}) - poseMisfit(others.pairs);
        return judged(landmark, std::min(apart, square), 3.0);
    }

    [[nodiscard]] TouchFinding asLandmark(const Guess& guess) const
    {
        TouchFinding finding;
        finding.verdict =
            m_earlier.p_TQ[guess.landmark] ? TouchVerdict::Again : TouchVerdict::Landmark;
        finding.landmark = guess.landmark;
        const Named others = m_named.without(guess.landmark);
        if (const auto fit = fitRigid(others.pairs))
            finding.distance = metres((m_earlier.p_AQ[guess.landmark] - fit->X_AM * m_p_TQ).norm());
        return finding;
    }

    /// Whether all touches fit together as assigned; a repeated touch is not tested.
    [[nodiscard]] bool agrees(const Guess& guess) const
    {
        if (!guess.isPlausible || m_earlier.p_TQ[guess.landmark])
            return guess.isPlausible;
        const double degrees = 3.0 * double(m_named.pairs.size() + 1) - 6.0;
        const double misfit = m_named.misfitWith({m_earlier.p_AQ[guess.landmark], m_p_TQ});
        return degrees < 3.0 || misfit / m_variance <= plausibleChiSquared(degrees);
    }

    [[nodiscard]] std::optional<TouchFinding> anotherNaming() const;

    const TouchesSoFar& m_earlier;
    const Vec3& m_p_TQ;
    double m_variance; ///< of a touch along one direction, m^2
    Named m_named;
};

/// Searches the assignments of touches in which all distances agree.
class NamingSearch
{
public:
    NamingSearch(std::span<const Vec3> p_AQ, std::span<const Vec3> p_TQ, double variance)
        : m_p_AQ{p_AQ},
          m_p_TQ{p_TQ},
          m_variance{variance},
          m_tolerance{kFarthestDeviations * std::sqrt(2.0 * variance)}
    {
    }

    /// @returns the landmark of each touch, if exactly one assignment explains them; else nothing.
    std::vector<std::size_t> run()
    {
        const double limit = plausibleChiSquared(3.0 * double(m_p_TQ.size()) - 6.0);
        const bool isClear = name() && m_least <= limit && m_second > m_least + kClearLead;
        return isClear ? m_best : std::vector<std::size_t>{};
    }

private:
    /// Tries all remaining landmarks for the next touch. @returns false beyond kMostOrders.
    bool name()
    {
        if (++m_looked > kMostOrders)
            return false;
        const std::size_t touch = m_pairs.size();
        if (touch == m_p_TQ.size()) {
            judge();
            return true;
        }
        for (std::size_t landmark = 0; landmark < m_p_AQ.size(); ++landmark) {
            const LandmarkPair pair{m_p_AQ[landmark], m_p_TQ[touch]};
            if (std::ranges::find(m_landmarks, landmark) != m_landmarks.end() || !agrees(pair))
                continue;
            m_pairs.push_back(pair);
            m_landmarks.push_back(landmark);
            const bool goesOn = name();
            m_pairs.pop_back();
            m_landmarks.pop_back();
            if (!goesOn)
                return false;
        }
        return true;
    }

    [[nodiscard]] bool agrees(const LandmarkPair& pair) const
    {
        return std::ranges::all_of(m_pairs, [&](const LandmarkPair& before) {
            const double ofLandmarks = (pair.p_AQ - before.p_AQ).norm();
            return std::abs(ofLandmarks - (pair.p_MQ - before.p_MQ).norm()) <= m_tolerance;
        });
    }

    void judge()
    {
        const double chiSquared = poseMisfit(m_pairs) / m_variance;
        if (chiSquared < m_least) {
            m_second = m_least;
            m_least = chiSquared;
            m_best = m_landmarks;
        } else {
            m_second = std::min(m_second, chiSquared);
        }
    }

    std::span<const Vec3> m_p_AQ;
    std::span<const Vec3> m_p_TQ;
    double m_variance;
    double m_tolerance;
    std::vector<LandmarkPair> m_pairs{};
    std::vector<std::size_t> m_landmarks{};
    std::vector<std::size_t> m_best{};
    double m_least = std::numeric_limits<double>::infinity();
    double m_second = std::numeric_limits<double>::infinity();
    std::size_t m_looked = 0;
};

/// Requires at least four touches.
std::optional<TouchFinding> Recognition::anotherNaming() const
{
    if (m_named.pairs.size() < 3)
        return std::nullopt;
    std::vector<Vec3> touches;
    for (const LandmarkPair& pair : m_named.pairs)
        touches.push_back(pair.p_MQ);
    touches.push_back(m_p_TQ);
    const auto landmarkOf = NamingSearch{m_earlier.p_AQ, touches, m_variance}.run();
    if (landmarkOf.empty()
        || std::ranges::equal(m_named.landmarks, std::span{landmarkOf}.first(touches.size() - 1)))
        return std::nullopt;
    TouchFinding finding{.verdict = TouchVerdict::Renamed, .landmark = landmarkOf.back()};
    finding.renamed_p_TQ.resize(m_earlier.p_AQ.size());
    for (std::size_t i = 0; i < touches.size(); ++i)
        finding.renamed_p_TQ[landmarkOf[i]] = touches[i];
    return finding;
}

Result<void> check(const TouchesSoFar& earlier, const Vec3& p_TQ)
{
    if (earlier.p_AQ.size() < 3)
        return fail(Errc::TooFewLandmarks,
                    std::to_string(earlier.p_AQ.size()) + " landmarks, and 3 are the fewest");
    for (const Vec3& place : earlier.p_AQ) {
        if (const auto sound = checkPoint(place, "a landmark of the anatomy"); !sound)
            return sound;
    }
    for (const std::optional<Vec3>& touch : earlier.p_TQ) {
        if (const auto sound = touch ? checkPoint(*touch, "a touch") : Result<void>{}; !sound)
            return sound;
    }
    return checkPoint(p_TQ, "the touch");
}

/// Manikins of other sizes than these, relative to the anatomy, are not looked for.
constexpr double kLeastSize = 0.8;
constexpr double kMostSize = 1.25;

/// What a touch is that lies where a landmark of a larger or smaller manikin would be.
std::optional<TouchFinding> ofAnotherSize(const TouchesSoFar& earlier, const Vec3& p_TQ, Length fle,
                                          std::size_t landmark)
{
    if (earlier.p_TQ[landmark])
        return std::nullopt;
    std::vector<LandmarkPair> pairs{{earlier.p_AQ[landmark], p_TQ}};
    for (std::size_t i = 0; i < earlier.p_AQ.size(); ++i)
        if (earlier.p_TQ[i])
            pairs.push_back({earlier.p_AQ[i], *earlier.p_TQ[i]});
    const Result<ManikinScale> size = manikinScale(pairs);
    if (!size || !size->isOff() || size->scale < kLeastSize || size->scale > kMostSize)
        return std::nullopt;
    std::vector<Vec3> scaled{earlier.p_AQ.begin(), earlier.p_AQ.end()};
    for (Vec3& p_AQ : scaled)
        p_AQ *= size->scale;
    const TouchesSoFar ofManikin{scaled, earlier.p_TQ};
    TouchFinding found = Recognition{ofManikin, p_TQ, fle}.finding(landmark);
    const bool isIt = found.verdict == TouchVerdict::Landmark && found.landmark == landmark;
    return isIt ? std::optional{std::move(found)} : std::nullopt;
}

} // namespace

Result<TouchFinding> recogniseTouch(const TouchesSoFar& earlier, const Vec3& p_TQ, Length fle,
                                    std::optional<std::size_t> proposed)
{
    CARINA_EXPECTS(earlier.p_AQ.size() == earlier.p_TQ.size());
    CARINA_EXPECTS(fle.si > 0.0);
    CARINA_EXPECTS(!proposed || (*proposed < earlier.p_TQ.size() && !earlier.p_TQ[*proposed]));
    if (const auto sound = check(earlier, p_TQ); !sound)
        return tl::unexpected(sound.error());
    TouchFinding found = Recognition{earlier, p_TQ, fle}.finding(proposed);
    if (found.verdict != TouchVerdict::Nowhere)
        return found;
    if (proposed)
        if (auto asked = ofAnotherSize(earlier, p_TQ, fle, *proposed))
            return *asked;
    return ofAnotherSize(earlier, p_TQ, fle, found.landmark).value_or(std::move(found));
}

} // namespace carina
