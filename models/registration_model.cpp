#include "models/registration_model.h"

#include "engine/registration/pivot_calibration.h"
#include "models/error_text.h"
#include "models/registration_words.h"
#include "models/site_changes.h"

#include <QDateTime>

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kStylusInterval_ms = 33;

} // namespace

Result<Site> RegistrationModel::siteOf(const std::filesystem::path& file,
                                       const PatientModel& patient)
{
    Result<Site> site = readSiteFile(file);
    if (!site && site.error().code == Errc::FileNotFound)
        return Site{};
    if (site && site->catalogue && !site->catalogue->anatomy.empty()
        && site->catalogue->anatomy != patient.contentHash())
        return fail(Errc::OtherPatient, file.string());
    return site;
}

RegistrationModel::RegistrationModel(Workplace workplace, Site site, const PatientModel& patient,
                                     QObject* parent)
    : QObject{parent},
      m_workplace{std::move(workplace)},
      m_site{std::move(site)},
      m_patient{patient},
      m_stylus{*m_workplace.tracker, m_workplace.clock},
      m_surfaces{patient}
{
    connect(&m_timer, &QTimer::timeout, this, &RegistrationModel::look);
    m_timer.start(kStylusInterval_ms);
}

bool RegistrationModel::isDone(SiteStep step) const
{
    switch (step) {
    case SiteStep::Tracker:
        return m_site.tracker == m_workplace.trackerName.toStdString();
    case SiteStep::Stylus:
        return m_site.stylus.has_value();
    case SiteStep::Landmarks:
        return m_site.catalogue.has_value();
    case SiteStep::Touch:
        return m_site.catalogue && m_site.touched.size() == m_site.catalogue->landmarks.size();
    case SiteStep::Fit:
        return m_site.registration.has_value();
    case SiteStep::Verify:
        break; // goes on for as long as somebody likes
    }
    return false;
}

QString RegistrationModel::whyNot(SiteStep step) const { return whyNotYet(*this, step); }

bool RegistrationModel::canEnter(SiteStep step) const { return whyNot(step).isEmpty(); }

QString RegistrationModel::instruction() const { return registrationInstruction(*this); }

std::vector<ToolStatus> RegistrationModel::tools() const
{
    const auto now = m_workplace.clock();
    return now ? toolStatus(*m_workplace.tracker, *now) : std::vector<ToolStatus>{};
}

const LandmarkCatalogue& RegistrationModel::catalogue() const
{
    return m_site.catalogue ? *m_site.catalogue : m_workplace.landmarks;
}

std::vector<LandmarkRow> RegistrationModel::landmarks() const
{
    const std::optional<std::size_t> next = nextLandmark();
    std::vector<LandmarkRow> rows;
    for (const Landmark& landmark : catalogue().landmarks) {
        LandmarkRow row{.name = QString::fromStdString(landmark.name),
                        .p_AQ = landmark.p_AQ,
                        .isNext = next == rows.size()};
        if (const TouchedPoint* touch = touchOf(m_site, landmark.name))
            row.spread_mm = inMillimetres(metres(touch->spread));
        if (m_site.registration) {
            const auto& residuals = m_site.registration->residuals;
            const auto residual =
                std::ranges::find(residuals, landmark.name, &LandmarkResidual::landmark);
            if (residual != residuals.end())
                row.residual_mm = inMillimetres(metres(residual->residual));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

std::optional<std::size_t> RegistrationModel::nextLandmark() const
{
    const auto& all = catalogue().landmarks;
    if (m_chosen && *m_chosen < all.size())
        return m_chosen;
    if (step() != SiteStep::Touch)
        return std::nullopt;
    const auto untouched = std::ranges::find_if(
        all, [this](const Landmark& landmark) { return !touchOf(m_site, landmark.name); });
    return untouched == all.end() ? std::nullopt
                                  : std::optional{std::size_t(untouched - all.begin())};
}

double RegistrationModel::progress() const
{
    if (m_stylus.isSwinging())
        return m_stylus.swingProgress();
    return step() == SiteStep::Touch && nextLandmark() ? m_stylus.holdProgress() : 0.0;
}

void RegistrationModel::enter(SiteStep step)
{
    if (!canEnter(step))
        return;
    m_stylus.cancelSwing();
    m_stylus.forgetHold();
    m_chosen.reset();
    Site next = m_site;
    next.step = step;
    if (!save(std::move(next)))
        m_site.step = step; // a page can be looked at, whatever the disk says
    Q_EMIT changed();
}

void RegistrationModel::useTracker()
{
    Site next = withTracker(m_site, m_workplace.trackerName.toStdString());
    next.step = SiteStep::Stylus;
    become(std::move(next));
}

void RegistrationModel::startSwing()
{
    m_stylus.startSwing();
    m_problem.clear();
    Q_EMIT changed();
}

void RegistrationModel::cancelSwing()
{
    m_stylus.cancelSwing();
    Q_EMIT changed();
}

void RegistrationModel::acceptLandmarks()
{
    Site next = withLandmarks(m_site, catalogue());
    next.step = m_site.stylus ? SiteStep::Touch : SiteStep::Stylus;
    m_stylus.forgetHold();
    m_chosen.reset();
    become(std::move(next));
}

void RegistrationModel::useBuiltinLandmarks()
{
    if (catalogue() != m_workplace.landmarks)
        become(withLandmarks(m_site, m_workplace.landmarks));
}

void RegistrationModel::choose(std::size_t landmark)
{
    m_chosen = landmark;
    m_stylus.forgetHold();
    Q_EMIT changed();
}

void RegistrationModel::pick(const Vec3& p_A_eye, const Vec3& dir_A)
{
    if (step() != SiteStep::Landmarks || !m_chosen || *m_chosen >= catalogue().landmarks.size())
        return;
    const auto met = m_surfaces.along(p_A_eye, dir_A);
    if (!met) {
        m_problem = tr("There is nothing of the patient at that place: click on the model.");
        Q_EMIT changed();
        return;
    }
    LandmarkCatalogue moved = catalogue();
    moved.landmarks[*m_chosen].p_AQ = p_A_eye + met->distance * dir_A.normalized();
    become(withLandmarks(m_site, std::move(moved)));
}

void RegistrationModel::fit()
{
    if (!canEnter(SiteStep::Fit))
        return;
    Result<Site> next = withFit(m_site, m_stylus.chin());
    if (!next)
        return refuse(next.error());
    next->step = SiteStep::Fit;
    become(std::move(*next));
}

void RegistrationModel::undo()
{
    if (m_past.empty() || !save(m_past.back()))
        return;
    m_past.pop_back();
    m_stylus.cancelSwing();
    m_chosen.reset();
    m_stylus.forgetHold();
    Q_EMIT changed();
}

void RegistrationModel::look()
{
    const bool touching = step() == SiteStep::Touch && nextLandmark();
    const auto tip = touching && m_site.stylus ? std::optional{m_site.stylus->p_SQ} : std::nullopt;
    const StylusWatch::News news = m_stylus.look(tip);
    if (!news.swing.empty())
        takeSwing(news.swing);
    if (news.touch && touching)
        takeTouch(*news.touch);
    m_stylusOnAnatomy = step() == SiteStep::Verify ? foundStylus() : std::nullopt;
}

void RegistrationModel::takeSwing(const std::vector<RigidTransform>& X_TS)
{
    const Result<PivotCalibration> pivot = calibratePivot(X_TS);
    if (!pivot)
        return refuse(pivot.error());
    const QString now = QDateTime::currentDateTimeUtc().toString(Qt::ISODate);
    become(withStylus(m_site, {pivot->p_SQ, pivot->rms, now.toStdString()}));
}

void RegistrationModel::takeTouch(const DwellPoint& point)
{
    const std::string& landmark = catalogue().landmarks[*nextLandmark()].name;
    m_chosen.reset();
    if (become(withTouch(m_site, landmark, point)))
        Q_EMIT touched();
}

std::optional<StylusOnAnatomy> RegistrationModel::foundStylus() const
{
    const auto X_TS = m_stylus.stylus();
    if (!X_TS || !m_site.registration || !m_site.stylus)
        return std::nullopt;
    StylusOnAnatomy found{.X_AS = m_site.registration->X_AT * *X_TS};
    found.p_AQ = found.X_AS * m_site.stylus->p_SQ;
    if (const auto surface = m_surfaces.nearest(found.p_AQ)) {
        found.nearestSurface = QString::fromStdString(surface->name);
        found.surface_mm = inMillimetres(metres(surface->distance));
    }
    const auto distance = [&](const Landmark& q) { return (q.p_AQ - found.p_AQ).norm(); };
    const Landmark& nearest = std::ranges::min(catalogue().landmarks, {}, distance);
    found.nearestLandmark = QString::fromStdString(nearest.name);
    found.landmark_mm = inMillimetres(metres(distance(nearest)));
    return found;
}

bool RegistrationModel::become(Site next)
{
    Site past = m_site;
    if (!save(std::move(next)))
        return false;
    m_past.push_back(std::move(past));
    Q_EMIT changed();
    return true;
}

bool RegistrationModel::save(Site next)
{
    if (const auto written = writeSiteFile(m_workplace.file, next); !written) {
        refuse(written.error());
        return false;
    }
    m_site = std::move(next);
    m_problem.clear();
    return true;
}

void RegistrationModel::refuse(const Error& error)
{
    m_problem = errorText(error);
    Q_EMIT changed();
}

} // namespace carina
