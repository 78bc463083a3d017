#include "ui/registration/registration_window.h"

#include "models/errors/error_text.h"
#include "ui/registration/fit_page.h"
#include "ui/registration/landmarks_page.h"
#include "ui/registration/overview_page.h"
#include "ui/registration/registration_paper.h"
#include "ui/registration/stylus_page.h"
#include "ui/registration/tools_page.h"
#include "ui/registration/touch_page.h"
#include "ui/registration/tracker_page.h"
#include "ui/registration/verify_page.h"
#include "ui_registration_window.h"

#include <QAccessible>
#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QPainter>
#include <QShortcut>

#include <array>

namespace carina
{
namespace
{

constexpr int kLiveInterval_ms = 66;
constexpr int kToolsInterval_ms = 500; ///< slow enough to read the numbers
constexpr std::array kSteps{SiteStep::Overview,  SiteStep::Tracker, SiteStep::Stylus,
                            SiteStep::Landmarks, SiteStep::Touch,   SiteStep::Fit,
                            SiteStep::Verify,    SiteStep::Tools};

StepState stateOf(TaskState state)
{
    switch (state) {
    case TaskState::Open:
        return StepState::Open;
    case TaskState::Waits:
        return StepState::Waits;
    case TaskState::Begun:
        return StepState::Begun;
    case TaskState::Done:
        return StepState::Done;
    case TaskState::Stale:
        return StepState::Stale;
    }
    return StepState::Open;
}

/// What the page needs to see.
bool isOfUse(const ToolStatus& tool, SiteStep step)
{
    if (step == SiteStep::Tools)
        return tool.role == ToolRole::Stylus || tool.role == ToolRole::Tube
               || tool.role == ToolRole::Laryngoscope;
    return tool.role == ToolRole::Stylus || tool.role == ToolRole::Jaw
           || tool.role == ToolRole::Manikin;
}

QString toolText(const ToolStatus& tool)
{
    return QStringLiteral("%1 %2\n     %3")
        .arg(tool.isVisible ? QStringLiteral("✓") : QStringLiteral("▲"), tool.name, tool.text);
}

void keepPlaceWhenHidden(QWidget& widget)
{
    QSizePolicy policy = widget.sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget.setSizePolicy(policy);
}

} // namespace

RegistrationWindow::RegistrationWindow(RegistrationModel& registration, PoseRecording& recording)
    : m_ui{std::make_unique<Ui::RegistrationWindow>()},
      m_registration{registration},
      m_recording{recording}
{
    m_ui->setupUi(this);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_ui->progress, m_ui->next})
        keepPlaceWhenHidden(*widget);
    m_ui->scene->setBackground(palette().color(QPalette::Base));
    m_ui->patient->setText(
        tr("Patient: %1").arg(QString::fromStdString(m_registration.patient().name())));
    m_ui->tracker->setText(tr("Tracker: %1").arg(m_registration.trackerName()));
    addPages();
    m_scene = std::make_unique<RegistrationScene>(*m_ui->scene, m_registration);
    connectButtons();
    connectModel();
    refresh();
    m_ui->primary->setFocus();
}

RegistrationWindow::~RegistrationWindow() = default;

void RegistrationWindow::addPages()
{
    auto* overview = new OverviewPage{m_registration};
    connect(overview, &OverviewPage::finished, this, &QWidget::close);
    connect(overview, &OverviewPage::reportWanted, this, &RegistrationWindow::askForReport);
    auto* tracker = new TrackerPage{m_registration, m_recording};
    connect(tracker, &TrackerPage::anotherWanted, this, &RegistrationWindow::anotherTrackerWanted);
    connect(tracker, &TrackerPage::devicesWanted, this, &RegistrationWindow::siteDevicesWanted);
    m_pages = {overview,
               tracker,
               new StylusPage{m_registration},
               new LandmarksPage{m_registration},
               new TouchPage{m_registration},
               new FitPage{m_registration},
               new VerifyPage{m_registration},
               new ToolsPage{m_registration}};
    for (RegistrationPage* each : m_pages)
        m_ui->pages->addWidget(each);
}

void RegistrationWindow::connectButtons()
{
    connect(m_ui->steps, &StepList::chosen, this,
            [this](int step) { m_registration.enter(kSteps[std::size_t(step)]); });
    connect(m_ui->primary, &QPushButton::clicked, this, [this] { page().act(); });
    connect(m_ui->next, &QPushButton::clicked, this, &RegistrationWindow::enterNext);
    connect(m_ui->showError, &QCheckBox::toggled, this, &RegistrationWindow::refreshError);
    connect(m_ui->undo, &QPushButton::clicked, &m_registration, &RegistrationModel::undo);
    connect(m_ui->scene, &SceneView::clicked, &m_registration, &RegistrationModel::pick);
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) {
        auto* goOn = new QShortcut{key, this};
        connect(goOn, &QShortcut::activated, this, [this] {
            if (auto* typed = qobject_cast<QLineEdit*>(focusWidget()))
                typed->clearFocus(); // which takes what was typed
            if (mainButton().isDefault())
                mainButton().click();
        });
    }
    auto* take = new QShortcut{Qt::Key_PageDown, this};
    connect(take, &QShortcut::activated, &m_registration, &RegistrationModel::takeNow);
    auto* undo = new QShortcut{QKeySequence::Undo, this};
    connect(undo, &QShortcut::activated, &m_registration, &RegistrationModel::undo);
}

void RegistrationWindow::connectModel()
{
    connect(&m_registration, &RegistrationModel::changed, this, &RegistrationWindow::refresh);
    connect(&m_registration, &RegistrationModel::told, this, &RegistrationWindow::hear);
    connect(&m_registration, &RegistrationModel::devicesChanged, this,
            &RegistrationWindow::siteDevicesWanted);
    auto* live = new QTimer{this};
    connect(live, &QTimer::timeout, this, &RegistrationWindow::refreshProgress);
    live->start(kLiveInterval_ms);
    auto* slow = new QTimer{this};
    connect(slow, &QTimer::timeout, this, &RegistrationWindow::refreshTools);
    connect(slow, &QTimer::timeout, this, [this] {
        page().refreshLive();
        m_ui->instruction->setText(m_registration.instruction());
    });
    slow->start(kToolsInterval_ms);
}

RegistrationPage& RegistrationWindow::page() const
{
    return *m_pages[std::size_t(m_registration.step())];
}

/// A stack of pages is as large as its largest: only the one that is seen has a say in it, so that
/// the others make it no scroll bars.
void RegistrationWindow::turnPage()
{
    for (RegistrationPage* each : m_pages) {
        const bool isSeen = each == &page();
        const auto policy = isSeen ? QSizePolicy::Preferred : QSizePolicy::Ignored;
        each->setSizePolicy(policy, policy);
    }
    m_ui->pages->setCurrentWidget(&page());
}

void RegistrationWindow::refresh()
{
    m_scene->refresh();
    m_ui->instruction->setText(m_registration.instruction());
    if (m_registration.notice().isEmpty())
        m_ui->message->warn(m_registration.problem());
    else
        m_ui->message->confirm(m_registration.notice());
    turnPage();
    page().refresh();
    refreshSteps();
    refreshButtons();
    refreshError();
    refreshProgress();
    refreshTools();
}

/// The error is looked at where no landmark is asked for.
void RegistrationWindow::refreshError()
{
    const SiteStep step = m_registration.step();
    const bool isOfUse = m_registration.fitting().errorQuadric()
                         && (step == SiteStep::Overview || step == SiteStep::Fit);
    m_ui->showError->setVisible(isOfUse);
    const auto shown = m_scene->showError(isOfUse && m_ui->showError->isChecked());
    m_ui->errorScale->setVisible(shown.has_value());
    if (shown)
        m_ui->errorScale->setScale(shown->bands, shown->range);
}

Result<void> RegistrationWindow::writeReport(const QString& file)
{
    return writeRegistrationReport(file.toStdString(),
                                   reportOf(m_registration, pictureWithScale()));
}

/// The patient as it is shown, and beneath it what its colours say.
QImage RegistrationWindow::pictureWithScale() const
{
    const QImage patient = m_ui->scene->picture();
    if (!m_ui->errorScale->isVisible() || patient.isNull())
        return patient;
    const QImage scale =
        m_ui->errorScale->grab().toImage().scaledToWidth(patient.width(), Qt::SmoothTransformation);
    QImage both{patient.width(), patient.height() + scale.height(), QImage::Format_RGB32};
    both.fill(palette().color(QPalette::Window));
    QPainter painter{&both};
    painter.drawImage(0, 0, patient);
    painter.drawImage(0, patient.height(), scale);
    return both;
}

void RegistrationWindow::askForReport()
{
    const QString file =
        QFileDialog::getSaveFileName(this, tr("Report of the registration"),
                                     QStringLiteral("registration.pdf"), tr("PDF (*.pdf)"));
    if (file.isEmpty())
        return;
    if (const auto written = writeReport(file); !written)
        m_ui->message->warn(errorText(written.error()));
    else
        m_ui->message->confirm(
            tr("The report was written to %1.").arg(QDir::toNativeSeparators(file)));
}

void RegistrationWindow::refreshSteps()
{
    std::vector<StepList::Step> steps;
    for (const SiteStep step : kSteps) {
        const SiteTask task = m_registration.task(step);
        steps.push_back({.title = stepTitle(step),
                         .state = stateOf(task.state),
                         .isHere = step == m_registration.step(),
                         .why = task.why});
    }
    m_ui->steps->setSteps(steps);
}

void RegistrationWindow::refreshButtons()
{
    m_ui->primary->setText(page().actionText());
    m_ui->primary->setEnabled(page().canAct());
    m_ui->undo->setEnabled(m_registration.canUndo());
    m_ui->next->setVisible(m_registration.step() != SiteStep::Overview);
    m_ui->next->setText(nextStep() == SiteStep::Overview ? tr("To the &overview") : tr("Ne&xt"));
    for (QPushButton* button : {m_ui->primary, m_ui->next})
        button->setDefault(page().isReady() && button == &mainButton());
}

QPushButton& RegistrationWindow::mainButton() const
{
    if (m_registration.step() == SiteStep::Overview) // the last
        return *m_ui->primary;
    const bool goesOn = m_registration.task(m_registration.step()).state == TaskState::Done
                        && !m_registration.stylus().isLookingForTip()
                        && !m_registration.toolTask().isTouching();
    return *(goesOn || !page().canAct() ? m_ui->next : m_ui->primary);
}

/// A tracker without tools to calibrate leads past their page.
SiteStep RegistrationWindow::nextStep() const
{
    const std::size_t next = std::size_t(m_registration.step()) + 1;
    if (next == kSteps.size())
        return SiteStep::Overview;
    const bool hasNone = m_registration.toolTask().offered().empty();
    return kSteps[next] == SiteStep::Tools && hasNone ? SiteStep::Overview : kSteps[next];
}

void RegistrationWindow::enterNext() { m_registration.enter(nextStep()); }

void RegistrationWindow::refreshProgress()
{
    const int percent = qRound(100.0 * m_registration.progress());
    const bool swings = m_registration.step() == SiteStep::Stylus;
    if (swings) { // what they tell belongs to the bar
        page().refreshLive();
        m_ui->instruction->setText(m_registration.instruction());
    }
    m_ui->progress->setVisible(percent > 0);
    m_ui->progress->setValue(percent);
    m_ui->progress->setFormat(swings ? tr("Calibration %p %") : tr("Hold still %p %"));
}

/// By a sound, and by what reads the screen aloud.
void RegistrationWindow::hear(const QString& words)
{
    QApplication::beep();
    m_ui->instruction->setAccessibleDescription(words);
    QAccessibleEvent event{m_ui->instruction, QAccessible::Alert};
    QAccessible::updateAccessibility(&event);
}

void RegistrationWindow::refreshTools()
{
    QStringList texts;
    const bool isToldByPage = m_registration.step() == SiteStep::Tracker;
    if (const QString trouble = m_registration.trackerTrouble();
        !trouble.isEmpty() && !isToldByPage)
        texts << QStringLiteral("▲ ") + trouble;
    for (const ToolStatus& tool : m_registration.tools())
        if (isOfUse(tool, m_registration.step()))
            texts << toolText(tool);
    m_ui->tools->setText(texts.join(QLatin1Char('\n')));
}

} // namespace carina
