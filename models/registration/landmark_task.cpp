#include "models/registration/landmark_task.h"

#include "engine/core/expects.h"
#include "engine/io/site/landmark_exchange.h"
#include "engine/registration/landmarks/layout_check.h"
#include "models/site/site_changes.h"

#include <QCoreApplication>
#include <QDir>

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

class LandmarkWords
{
    Q_DECLARE_TR_FUNCTIONS(LandmarkTask)
};

std::vector<Vec3> placesOf(const LandmarkCatalogue& catalogue)
{
    std::vector<Vec3> places;
    for (const Landmark& landmark : catalogue.landmarks)
        places.push_back(landmark.p_AQ);
    return places;
}

/// Whether no two sides are nearly as long.
bool isScalene(const std::vector<Vec3>& corners)
{
    constexpr double kClear_m = 0.02;
    std::array<double, 3> sides{(corners[0] - corners[1]).norm(), (corners[1] - corners[2]).norm(),
                                (corners[2] - corners[0]).norm()};
    std::ranges::sort(sides);
    return sides[1] - sides[0] > kClear_m && sides[2] - sides[1] > kClear_m;
}

QString shownPath(const std::filesystem::path& file)
{
    return QDir::toNativeSeparators(QString::fromStdString(file.string()));
}

/// Files round: a landmark that is where it was stays exactly what it was.
void keepUnmoved(std::vector<Landmark>& landmarks, const std::vector<Landmark>& before)
{
    for (Landmark& landmark : landmarks) {
        const auto was = std::ranges::find(before, landmark.name, &Landmark::name);
        if (was != before.end()
            && (was->p_AQ - landmark.p_AQ).norm() <= LandmarkTask::kFileRounding.si)
            landmark = *was;
    }
}

} // namespace

LandmarkTask::LandmarkTask(SiteEditor& editor, const PatientModel& patient,
                           const SurfaceFinder& surfaces, std::vector<LandmarkCatalogue> offered)
    : m_editor{editor},
      m_patient{patient},
      m_surfaces{surfaces},
      m_offered{std::move(offered)},
      m_targets{registrationTargets(patient)}
{
    CARINA_EXPECTS(!m_offered.empty());
}

const LandmarkCatalogue& LandmarkTask::catalogue() const
{
    const auto& catalogue = m_editor.site().catalogue;
    return catalogue ? *catalogue : m_offered.front();
}

std::optional<std::size_t> LandmarkTask::chosenSet() const
{
    const auto found = std::ranges::find(m_offered, catalogue());
    return found == m_offered.end() ? std::nullopt
                                    : std::optional{std::size_t(found - m_offered.begin())};
}

void LandmarkTask::chooseSet(std::size_t offered)
{
    m_chosen.reset();
    if (m_offered.at(offered) != catalogue())
        m_editor.become(withLandmarks(m_editor.site(), m_offered[offered]));
}

std::optional<std::size_t> LandmarkTask::chosen() const
{
    return m_chosen && *m_chosen < catalogue().landmarks.size() ? m_chosen : std::nullopt;
}

void LandmarkTask::choose(std::optional<std::size_t> landmark)
{
    m_chosen = landmark;
    Q_EMIT m_editor.changed();
}

void LandmarkTask::setSnapping(bool snapping)
{
    m_snapping = snapping;
    Q_EMIT m_editor.changed();
}

void LandmarkTask::pick(const Vec3& p_A_eye, const Vec3& dir_A)
{
    if (!chosen())
        return;
    const auto place = m_surfaces.picked(p_A_eye, dir_A, m_snapping);
    if (!place)
        return m_editor.refuse(
            LandmarkWords::tr("The patient has no surface at that place: click on the model."));
    LandmarkCatalogue moved = catalogue();
    moved.landmarks[*m_chosen].p_AQ = *place;
    m_editor.become(withLandmarks(m_editor.site(), std::move(moved)));
}

void LandmarkTask::importFrom(const std::filesystem::path& file)
{
    auto imported = importLandmarks(file, m_patient.contentHash());
    if (!imported)
        return m_editor.refuse(imported.error());
    m_chosen.reset();
    keepUnmoved(imported->landmarks, catalogue().landmarks);
    if (imported->landmarks == catalogue().landmarks)
        return m_editor.confirm(
            LandmarkWords::tr("These landmarks are already in use: nothing has changed."));
    m_editor.become(withLandmarks(m_editor.site(), std::move(*imported)));
}

void LandmarkTask::exportTo(const std::filesystem::path& file)
{
    if (const auto exported = exportLandmarks(file, catalogue()); !exported)
        return m_editor.refuse(exported.error());
    m_editor.confirm(LandmarkWords::tr("The landmarks were written to %1.").arg(shownPath(file)));
}

void LandmarkTask::accept()
{
    Site next = withLandmarks(m_editor.site(), catalogue());
    next.step = SiteStep::Touch;
    m_chosen.reset();
    m_editor.become(std::move(next));
}

std::vector<ExpectedError> LandmarkTask::forecast() const
{
    const auto covariance = fitCovariance(equalErrors(placesOf(catalogue()), kForecastFle));
    return covariance ? expectedErrors(*covariance, kKnownExactly, m_targets)
                      : std::vector<ExpectedError>{};
}

Length LandmarkTask::worstError(const Mat6& covariance_A) const
{
    Length worst{};
    for (const RegistrationTarget& target : m_targets)
        worst = std::max(worst, targetError(covariance_A, target.p_A).rms);
    return worst;
}

std::vector<std::size_t> LandmarkTask::bestTriangle(const std::vector<std::size_t>& of) const
{
    const auto place = [&](std::size_t landmark) { return catalogue().landmarks[landmark].p_AQ; };
    std::vector<std::size_t> best;
    std::optional<Length> least;
    for (std::size_t i = 0; i < of.size(); ++i)
        for (std::size_t j = i + 1; j < of.size(); ++j)
            for (std::size_t k = j + 1; k < of.size(); ++k) {
                const std::vector<Vec3> corners{place(of[i]), place(of[j]), place(of[k])};
                const auto covariance = fitCovariance(equalErrors(corners, kForecastFle));
                if (!covariance || !isScalene(corners))
                    continue;
                const Length worst = worstError(*covariance);
                if (least && worst >= *least)
                    continue;
                least = worst;
                best = {of[i], of[j], of[k]};
            }
    return best;
}

std::optional<std::pair<QString, double>> LandmarkTask::wouldHelp() const
{
    std::vector<Landmark> others = m_offered.front().landmarks;
    std::erase_if(others, [&](const Landmark& other) {
        return std::ranges::count(catalogue().landmarks, other.name, &Landmark::name) > 0;
    });
    std::vector<Vec3> targets;
    for (const RegistrationTarget& target : m_targets)
        targets.push_back(target.p_A);
    const auto next = nextLandmark(
        equalErrors(placesOf(catalogue()), kForecastFle),
        equalErrors(placesOf({.name = {}, .anatomy = {}, .landmarks = others}), kForecastFle),
        targets);
    if (!next || !*next)
        return std::nullopt;
    return std::pair{QString::fromStdString(others[(*next)->candidate].name),
                     inMillimetres((*next)->worstRms)};
}

} // namespace carina
