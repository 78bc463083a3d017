#include "engine/registration/watch/registration_watch.h"

#include "engine/core/expects.h"
#include "engine/registration/error/error_bound.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <bit>

namespace carina
{
namespace
{

constexpr std::size_t kMostChecks = 16;
constexpr double kTests = 9.0; // two for each of five windows; for one check they are the same

/// The normal equations of (w, v, s) for some checks, in units of a touch's variance.
class Window
{
public:
    explicit Window(const Mat6& information) { m_normal.topLeftCorner<6, 6>() = information; }

    void add(const Vec3& p_AQ, const Vec3& d_A)
    {
        Eigen::Matrix<double, 3, 9> effect; // of (w, v, s) on a deviation
        effect << -crossMatrix(p_AQ), Mat3::Identity(), Mat3::Identity();
        m_normal += effect.transpose() * effect;
        m_right += effect.transpose() * d_A;
        m_squares += d_A.squaredNorm();
    }

    struct Judgement {
        double ofAll = 0.0;   ///< chi-squared of the deviations, nothing having moved
        double ofShift = 0.0; ///< and of the shift
        Vec3 shift_A = Vec3::Zero();
    };

    [[nodiscard]] Judgement judged(double variance) const
    {
        const Mat6 still = m_normal.topLeftCorner<6, 6>();
        const Eigen::Matrix<double, 6, 1> right = m_right.head<6>();
        const double explained = right.dot(still.ldlt().solve(right));
        const Mat9 inverse = m_normal.ldlt().solve(Mat9::Identity());
        const Vec3 shift = (inverse * m_right).tail<3>();
        const Mat3 covariance = inverse.bottomRightCorner<3, 3>();
        return {(m_squares - explained) / variance,
                shift.dot(covariance.ldlt().solve(shift)) / variance, shift};
    }

private:
    using Mat9 = Eigen::Matrix<double, 9, 9>;

    Mat9 m_normal = Mat9::Zero();
    Eigen::Matrix<double, 9, 1> m_right = Eigen::Matrix<double, 9, 1>::Zero();
    double m_squares = 0.0;
};

double varianceOf(Length fle) { return fle.si * fle.si / 3.0; }

} // namespace

bool isPositiveDefinite(const Mat6& covariance)
{
    return Eigen::LLT<Mat6>{covariance}.info() == Eigen::Success;
}

RegistrationWatch::RegistrationWatch(std::vector<Vec3> p_AQ, const Mat6& covariance_A,
                                     const Settings& settings)
    : m_p_AQ{std::move(p_AQ)}, m_settings{settings}, m_dwell{settings.dwell}
{
    CARINA_EXPECTS(!m_p_AQ.empty());
    CARINA_EXPECTS(settings.touch.si > 0.0);
    CARINA_EXPECTS(isPositiveDefinite(covariance_A));
    m_information =
        varianceOf(settings.touch) * Eigen::LLT<Mat6>{covariance_A}.solve(Mat6::Identity());
}

std::optional<LandmarkCheck> RegistrationWatch::push(SessionTime time, const Vec3& p_A_tip,
                                                     Validity validity)
{
    const std::optional<DwellPoint> point = m_dwell.push(time, p_A_tip, validity);
    if (!point)
        return std::nullopt;
    const auto nearest = std::ranges::min_element(
        m_p_AQ, {}, [&](const Vec3& p_AQ) { return (point->p_FQ - p_AQ).squaredNorm(); });
    const LandmarkCheck check{point->from, std::size_t(nearest - m_p_AQ.begin()),
                              point->p_FQ - *nearest};
    if (check.d_A.norm() > m_settings.search.si)
        return std::nullopt;
    add(check);
    return check;
}

void RegistrationWatch::add(const LandmarkCheck& check)
{
    CARINA_EXPECTS(check.landmark < m_p_AQ.size());
    m_latest.push_back(check);
    if (m_latest.size() > kMostChecks)
        m_latest.pop_front();
    judge();
}

void RegistrationWatch::judge()
{
    m_report = {};
    double least = 1.0;
    double clearest = -1.0; // of a shift
    Window window{m_information};
    for (std::size_t n = 1; n <= m_latest.size(); ++n) {
        const LandmarkCheck& check = m_latest[m_latest.size() - n];
        window.add(m_p_AQ[check.landmark], check.d_A);
        if (!std::has_single_bit(n))
            continue;
        const auto [ofAll, ofShift, shift_A] = window.judged(varianceOf(m_settings.touch));
        least = std::min({least, chiSquaredTail(std::max(0.0, ofAll), 3.0 * double(n)),
                          chiSquaredTail(std::max(0.0, ofShift), 3.0)});
        if (ofShift <= clearest)
            continue;
        clearest = ofShift;
        m_report.checks = n;
        m_report.shift_A = shift_A;
        m_report.since = check.time;
    }
    m_report.chance = std::min(1.0, kTests * least);
    m_report.state = m_report.chance < m_settings.limit ? WatchState::Drifted : WatchState::Good;
    if (m_report.state == WatchState::Good)
        m_report.since.reset();
}

} // namespace carina
