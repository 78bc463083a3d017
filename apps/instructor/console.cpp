#include "apps/instructor/console.h"

#include "engine/io/anatomy_set/anatomy_cache.h"
#include "models/errors/error_text.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <utility>

namespace carina
{
namespace
{

QString consoleWords(const char* text) { return QApplication::translate("Instructor", text); }

/// Where the wizard keeps its site unless it was told otherwise; empty where there is none.
QString wizardsSite()
{
    const QDir own{QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)};
    const QString site =
        QDir::cleanPath(own.filePath(QStringLiteral("../carina-registration/site.json")));
    return QFileInfo::exists(site) ? site : QString{};
}

} // namespace

Console::Console(const QCommandLineParser& parser, ConsoleOptions options, ConsoleTracker tracker)
    : m_parser{parser},
      m_options{std::move(options)},
      m_plan{.name = consoleWords("Routine intubation"),
             .patient = program::patientOption(parser),
             .folder = program::anatomyOption(parser),
             .site = m_options.site.isEmpty() ? wizardsSite() : m_options.site,
             .reach = m_options.reach},
      m_tracker{std::move(tracker)}
{
}

Console::~Console() = default;

Result<void> Console::begin()
{
    if (m_options.asksFirst)
        showStart();
    else if (const auto begun = beginByOptions(); !begun)
        return begun;
    m_script = program::scriptFromOptions(m_parser, [this]() -> QWidget& { return shown(); });
    return {};
}

Result<void> Console::beginByOptions()
{
    const bool isAskedFor = program::namesPatient(m_parser);
    const auto asked = isAskedFor ? program::choosePatient(m_parser).map(
                           [](auto&& patient) { return std::optional{std::move(patient)}; })
                                  : Result<std::optional<program::ChosenPatient>>{};
    if (!asked)
        return tl::unexpected(asked.error());
    auto hosted = hostByOptions(m_options, program::importsPatient(m_parser));
    if (!hosted)
        return tl::unexpected(hosted.error());
    return open(*std::move(hosted), *asked);
}

void Console::showStart()
{
    m_stored = std::make_unique<StoredSessionsModel>(m_options.folder);
    m_patient = std::make_unique<PlannedPatient>(AnatomyCache::defaultFolder());
    m_start = std::make_unique<StartPage>(
        *m_stored, *m_patient, m_plan, [this](const QString& site, const PatientModel* patient) {
            return readiness({.site = site,
                              .folder = m_options.folder,
                              .patient = patient,
                              .today = QDateTime::currentDateTimeUtc()});
        });
    connect(m_start.get(), &StartPage::importWanted, this, &Console::import, Qt::QueuedConnection);
    connect(m_start.get(), &StartPage::beginWanted, this, &Console::beginNew, Qt::QueuedConnection);
    connect(m_start.get(), &StartPage::resumeWanted, this, &Console::resume, Qt::QueuedConnection);
    m_start->resize(m_options.measure.size);
    m_start->show();
    if (!m_plan.folder.isEmpty())
        import(m_plan.folder);
}

void Console::import(const QString& folder)
{
    if (!m_start)
        return; // a session was begun meanwhile
    const auto patient = program::importForPerson(folder);
    if (patient)
        m_patient->take({patient->model, patient->dimensions});
    m_start->warn(patient || patient.error().code == Errc::Cancelled ? QString{}
                                                                     : errorText(patient.error()));
}

void Console::beginNew(const SessionPlan& plan)
{
    if (!m_start || !m_patient->patient())
        return;
    m_plan = plan;
    const auto file = newSessionFile(m_options.folder);
    const auto& patient = *m_patient->patient();
    const auto begun = file.and_then([&](const QString& name) {
        return host({plan.name, name, plan.reach, !plan.folder.isEmpty()},
                    program::ChosenPatient{patient.model, patient.dimensions});
    });
    if (!begun)
        m_start->warn(errorText(begun.error()));
}

void Console::resume(const QString& file, SessionReach reach)
{
    if (!m_start)
        return;
    m_plan = m_start->plan();
    if (const auto resumed = host({m_plan.name, file, reach, false}, std::nullopt); !resumed)
        m_start->warn(errorText(resumed.error()));
}

/// @param laid the patient to be laid; nothing: the one that lies there
Result<void> Console::host(const HostRequest& request,
                           const std::optional<program::ChosenPatient>& laid)
{
    m_stored->stop(); // a file is open to one
    m_start->setBusy(true);
    QApplication::setOverrideCursor(Qt::WaitCursor);
    auto hosted = hostSession(request, m_options);
    const auto opened =
        hosted ? open(*std::move(hosted), laid) : Result<void>{tl::unexpected(hosted.error())};
    QApplication::restoreOverrideCursor();
    m_start->setBusy(false);
    if (opened)
        leaveStart();
    else
        m_stored->read(); // go on looking
    return opened;
}

Result<void> Console::open(HostedSession hosted, const std::optional<program::ChosenPatient>& laid)
{
    auto patient = laid ? Result<program::ChosenPatient>{*laid}
                        : program::patientForStart(presentPatient(*hosted.node), m_parser);
    if (!patient)
        return tl::unexpected(patient.error());
    auto session = ConsoleSession::open(std::move(hosted), *patient, laid.has_value(), m_options,
                                        m_tracker, m_parser);
    if (!session)
        return tl::unexpected(session.error());
    m_session = *std::move(session);
    if (m_options.measure.folder.isEmpty())
        m_session->onEnded([this] { showEnd(); });
    m_session->onLeft(
        [this] { QMetaObject::invokeMethod(this, &Console::goToStart, Qt::QueuedConnection); });
    return {};
}

void Console::leaveStart()
{
    m_start->hide();
    m_start.reset();
    m_patient.reset();
    m_stored.reset();
}

/// The session is hosted on, so that everybody hears that it has ended.
void Console::showEnd()
{
    const auto state = m_session->node().state();
    const SessionTime now = m_session->node().now().value_or(SessionTime{});
    m_end = std::make_unique<EndPage>(
        summaryOf(*state, now, m_session->node().self(), m_session->file()));
    connect(
        m_end.get(), &EndPage::anotherWanted, this,
        [this] {
            m_session->finish();
            m_session.reset(); // gives its port back
            showStart();
            m_end.reset();
        },
        Qt::QueuedConnection);
    m_end->resize(m_session->window().size());
    m_end->move(m_session->window().pos());
    m_end->show();
    m_session->window().hide();
}

/// The session is closed once there is another window, and is listed once it is closed.
void Console::goToStart()
{
    m_session->finish();
    showStart();
    m_session.reset();
    m_stored->read();
}

QWidget& Console::shown()
{
    if (m_end)
        return *m_end;
    return m_session ? static_cast<QWidget&>(m_session->window()) : *m_start;
}

} // namespace carina
