#include "models/registration/registration_model.h"

#include "engine/io/site/site_file.h"
#include "models/errors/error_text.h"
#include "models/registration/registration_words.h"
#include "models/site/site_changes.h"
#include "models/site/site_setup.h"

#include <QDir>

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kStylusInterval_ms = 33;

/// A site as its file has it, of this patient.
Result<Site> siteIn(const std::filesystem::path& file, const PatientModel& patient)
{
    Result<Site> site = readSiteFile(file);
    if (!site)
        return site;
    if (const auto isOf = checkPatient(*site, patient); !isOf)
        return fail(isOf.error().code, file.string() + ": " + isOf.error().detail);
    site->patient = patient.name();
    return site;
}

DeviceTask::Access accessOf(const RegistrationModel::Workplace& workplace)
{
    return {.tracker = workplace.tracker,
            .trackerName = workplace.trackerName,
            .clock = workplace.clock,
            .tracked = workplace.trackedDevices,
            .make = workplace.makeDevice,
            .track = workplace.track};
}

/// Its own, and the landmarks, of which a fit may leave some out.
std::vector<Landmark> placesToCheck(const RegistrationModel::Workplace& workplace)
{
    std::vector<Landmark> places = workplace.checks;
    const auto& landmarks = workplace.landmarks.front().landmarks;
    places.insert(places.end(), landmarks.begin(), landmarks.end());
    return places;
}

} // namespace

Result<Site> RegistrationModel::siteOf(const std::filesystem::path& file,
                                       const PatientModel& patient)
{
    Result<Site> site = siteIn(file, patient);
    if (!site && site.error().code == Errc::FileNotFound)
        return Site{.patient = patient.name()};
    return site;
}

RegistrationModel::RegistrationModel(Workplace workplace, Site site, const PatientModel& patient,
                                     QObject* parent)
    : QObject{parent},
      m_workplace{std::move(workplace)},
      m_patient{patient},
      m_editor{m_workplace.file, std::move(site), m_workplace.today, m_workplace.past},
      m_watch{*m_workplace.tracker, m_workplace.clock},
      m_surfaces{patient},
      m_stylusTask{m_editor, m_watch},
      m_landmarkTask{m_editor, patient, m_surfaces, m_workplace.landmarks},
      m_touchTask{m_editor, m_watch, m_landmarkTask},
      m_fitTask{m_editor, m_watch, patient, m_surfaces},
      m_verifyTask{m_editor, m_watch, patient, m_surfaces, placesToCheck(m_workplace)},
      m_manikinTask{m_editor, patient, m_landmarkTask},
      m_toolTask{m_editor, m_watch, patient},
      m_deviceTask{m_editor, m_workplace.file, accessOf(m_workplace)}
{
    connect(&m_editor, &SiteEditor::changed, this, &RegistrationModel::followStep);
    connect(&m_editor, &SiteEditor::told, this, &RegistrationModel::told);
    followStep();
    connect(&m_timer, &QTimer::timeout, this, &RegistrationModel::look);
    m_timer.start(kStylusInterval_ms);
}

/// The stylus is watched for what the page needs, with the tip as it is known now.
void RegistrationModel::followStep()
{
    const StylusTip* tip = m_stylusTask.tip();
    const std::optional<Vec3> p_SQ = tip ? std::optional{tip->p_SQ} : std::nullopt;
    const bool isAirway = m_manikinTask.isTouching();
    if (m_followed != step() || m_followedTip != p_SQ || m_followedAirway != isAirway
        || m_followedTool != touchedTool()) {
        m_followed = step();
        m_followedAirway = isAirway;
        m_followedTip = p_SQ;
        m_followedTool = touchedTool();
        m_watch.touchOn(m_followedTool);
        m_watch.setTip(p_SQ);
        m_watch.watchFor(use());
    }
    m_deviceTask.follow();
    Q_EMIT changed();
    if (m_deviceTask.isOutdated())
        Q_EMIT devicesChanged();
}

std::optional<ToolRole> RegistrationModel::touchedTool() const
{
    return step() == SiteStep::Tools && m_toolTask.isTouching() ? std::optional{m_toolTask.chosen()}
                                                                : std::nullopt;
}

StylusUse RegistrationModel::use() const
{
    if (step() == SiteStep::Touch || step() == SiteStep::Verify || m_manikinTask.isTouching()
        || touchedTool())
        return StylusUse::Touch;
    return step() == SiteStep::Stylus && !m_stylusTask.tip() ? StylusUse::Pivot
                                                             : StylusUse::Nothing;
}

SiteTask RegistrationModel::task(SiteStep step) const
{
    if (step == SiteStep::Tools)
        return m_toolTask.task();
    return siteTask(site(), step, m_watch.tool(), trackerName(), m_editor.today());
}

SiteStep RegistrationModel::nextStep() const
{
    return nextTask(site(), m_watch.tool(), trackerName(), m_editor.today());
}

QStringList RegistrationModel::health() const
{
    return siteHealth(site(), m_watch.tool(), trackerName(), m_editor.today(),
                      m_fitTask.expected());
}

QString RegistrationModel::instruction() const { return registrationInstruction(*this); }

QString RegistrationModel::trackerTrouble() const
{
    const std::string trouble = m_workplace.tracker->trouble();
    return trouble.empty() ? QString{} : errorText({Errc::TrackerFailed, trouble});
}

std::vector<ToolStatus> RegistrationModel::tools() const
{
    const auto now = m_workplace.clock();
    return now ? toolStatus(*m_workplace.tracker, *now) : std::vector<ToolStatus>{};
}

std::vector<LandmarkRow> RegistrationModel::landmarks() const
{
    const std::optional<std::size_t> next = nextLandmark();
    std::vector<LandmarkRow> rows;
    for (const Landmark& landmark : m_landmarkTask.catalogue().landmarks) {
        LandmarkRow row{.name = QString::fromStdString(landmark.name),
                        .p_AQ = landmark.p_AQ,
                        .isNext = next == rows.size()};
        if (const TouchedPoint* touch = m_touchTask.touchOf(landmark))
            row.spread_mm = inMillimetres(metres(touch->spread));
        else if (!m_touchTask.isRelaying())
            row.isStale = touchOf(site(), landmark.name) != nullptr;
        const auto& registration = site().registration;
        for (const LandmarkResidual& residual :
             registration ? registration->residuals : std::vector<LandmarkResidual>{}) {
            if (residual.landmark != landmark.name)
                continue;
            row.residual_mm = inMillimetres(metres(residual.residual));
            if (residual.leftOut)
                row.leftOut_mm = inMillimetres(metres(*residual.leftOut));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<LandmarkRow> RegistrationModel::places() const
{
    if (m_manikinTask.isTouching())
        return airwayPlaces();
    if (step() != SiteStep::Verify)
        return landmarks();
    std::vector<LandmarkRow> rows;
    const std::optional<std::size_t> next = m_verifyTask.next();
    for (const CheckPoint& point : m_verifyTask.points())
        rows.push_back({.name = point.name,
                        .p_AQ = point.p_AQ,
                        .spread_mm = point.error_mm,
                        .isNext = next == rows.size()});
    return rows;
}

/// Where the patient has the places that are touched in the manikin.
std::vector<LandmarkRow> RegistrationModel::airwayPlaces() const
{
    std::vector<LandmarkRow> rows;
    for (const AirwayPlace place : kAirwayPlaces) {
        const auto p_AQ = m_manikinTask.placeInPatient(place);
        if (!p_AQ)
            continue;
        LandmarkRow row{
            .name = airwayPlaceName(place), .p_AQ = *p_AQ, .isNext = m_manikinTask.next() == place};
        if (m_manikinTask.placeInManikin(place))
            row.spread_mm = 0.0;
        rows.push_back(std::move(row));
    }
    return rows;
}

std::optional<std::size_t> RegistrationModel::nextLandmark() const
{
    if (step() == SiteStep::Landmarks)
        return m_landmarkTask.chosen();
    return step() == SiteStep::Touch ? m_touchTask.next() : std::nullopt;
}

double RegistrationModel::progress() const
{
    return m_watch.use() == StylusUse::Touch && !awaitsTouch() ? 0.0 : m_watch.progress();
}

bool RegistrationModel::awaitsTouch() const
{
    if (m_manikinTask.isTouching())
        return true;
    if (step() == SiteStep::Tools)
        return m_toolTask.next().has_value();
    return step() == SiteStep::Touch ? m_touchTask.next().has_value()
                                     : step() == SiteStep::Verify && m_verifyTask.next();
}

std::optional<StylusOnAnatomy> RegistrationModel::stylusOnAnatomy() const
{
    const auto X_TS = m_watch.stylus();
    const StylusTip* tip = m_stylusTask.tip();
    if (!X_TS || !tip || !site().registration)
        return std::nullopt;
    StylusOnAnatomy found{.X_AS = site().registration->X_AT * *X_TS};
    found.p_AQ = found.X_AS * tip->p_SQ;
    if (const auto surface = m_surfaces.nearest(found.p_AQ)) {
        found.nearestSurface = QString::fromStdString(surface->name);
        found.surface_mm = inMillimetres(metres(surface->distance));
    }
    const auto distance = [&](const Landmark& q) { return (q.p_AQ - found.p_AQ).norm(); };
    const Landmark& nearest = std::ranges::min(m_landmarkTask.catalogue().landmarks, {}, distance);
    found.nearestLandmark = QString::fromStdString(nearest.name);
    found.landmark_mm = inMillimetres(metres(distance(nearest)));
    return found;
}

void RegistrationModel::look()
{
    const StylusNews news = m_watch.look();
    m_stylusTask.take(news);
    if (news.touch)
        take(*news.touch);
}

void RegistrationModel::takeNow()
{
    if (!awaitsTouch() || !m_stylusTask.tip())
        return;
    if (m_watch.restsWhereTaken())
        return m_editor.refuse(tr("The stylus is still where the last point was taken: move it to "
                                  "the next place and press again."));
    if (const auto touch = m_watch.takePoint())
        return take(*touch);
    m_editor.refuse(tr("The stylus is out of view: turn its markers to the tracker and press "
                       "again."));
}

void RegistrationModel::take(const StylusTouch& touch)
{
    if (m_manikinTask.isTouching())
        m_manikinTask.take(touch);
    else if (step() == SiteStep::Tools)
        m_toolTask.take(touch);
    else if (step() == SiteStep::Touch)
        m_touchTask.take(touch);
    else if (step() == SiteStep::Verify)
        m_verifyTask.take(touch);
}

void RegistrationModel::enter(SiteStep step)
{
    forgetChoices();
    m_editor.enter(step);
}

void RegistrationModel::forgetChoices()
{
    m_landmarkTask.choose(std::nullopt);
    m_touchTask.choose(std::nullopt);
    m_verifyTask.choose(std::nullopt);
    m_manikinTask.endTouch();
    if (m_toolTask.isTouching())
        m_toolTask.stop();
    m_followed.reset();
}

bool RegistrationModel::canUndo() const
{
    return m_editor.canUndo() || m_toolTask.canUndo()
           || (step() == SiteStep::Verify && m_verifyTask.hasPicked());
}

void RegistrationModel::setOperator(const QString& name)
{
    Site next = site();
    next.operatorName = name.trimmed().toStdString();
    if (next.operatorName != site().operatorName)
        m_editor.become(std::move(next));
}

void RegistrationModel::useTracker()
{
    if (!has(ToolRole::Stylus))
        return m_editor.refuse(registrationInstruction(*this));
    Site next = withTracker(site(), trackerName().toStdString());
    next.step = SiteStep::Stylus;
    m_editor.become(std::move(next));
}

void RegistrationModel::pick(const Vec3& p_A_eye, const Vec3& dir_A)
{
    if (step() == SiteStep::Landmarks)
        m_landmarkTask.pick(p_A_eye, dir_A);
    else if (step() == SiteStep::Verify && site().registration)
        m_verifyTask.pick(p_A_eye, dir_A);
}

void RegistrationModel::undo()
{
    if (m_toolTask.canUndo())
        return m_toolTask.undo();
    forgetChoices();
    if (step() == SiteStep::Verify && m_verifyTask.hasPicked())
        m_verifyTask.dropPicked();
    else
        m_editor.undo();
}

void RegistrationModel::exportSite(const QString& file)
{
    if (const auto written = writeSiteFile(file.toStdString(), site()); !written)
        return m_editor.refuse(written.error());
    m_editor.confirm(tr("The site was written to %1.").arg(QDir::toNativeSeparators(file)));
}

void RegistrationModel::importSite(const QString& file)
{
    Result<Site> imported = siteIn(file.toStdString(), m_patient);
    if (!imported)
        return m_editor.refuse(imported.error());
    imported->step = SiteStep::Overview;
    forgetChoices();
    m_editor.become(std::move(*imported));
}

} // namespace carina
