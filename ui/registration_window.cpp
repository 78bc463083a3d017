#include "ui/registration_window.h"

#include "ui_registration_window.h"
#include "widgets/residual_bar.h"

#include <QApplication>
#include <QHeaderView>
#include <QShortcut>

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kLiveInterval_ms = 66;
constexpr int kToolsInterval_ms = 500; ///< slow enough to read the numbers
constexpr int kLeastRow = 34;          ///< pixels, to be hit without aiming
constexpr double kLeastFullScale_mm = 2.0;
constexpr std::array kSteps{SiteStep::Tracker, SiteStep::Stylus, SiteStep::Landmarks,
                            SiteStep::Touch,   SiteStep::Fit,    SiteStep::Verify};

QString stepTitle(SiteStep step, const LandmarkTableModel& landmarks)
{
    switch (step) {
    case SiteStep::Tracker:
        return RegistrationWindow::tr("Tracker");
    case SiteStep::Stylus:
        return RegistrationWindow::tr("Stylus");
    case SiteStep::Landmarks:
        return RegistrationWindow::tr("Landmarks");
    case SiteStep::Touch:
        return RegistrationWindow::tr("Touch %1/%2")
            .arg(landmarks.touchedCount())
            .arg(landmarks.rowCount());
    case SiteStep::Fit:
        return RegistrationWindow::tr("Fit");
    case SiteStep::Verify:
        return RegistrationWindow::tr("Verify");
    }
    return {};
}

/// What a registration needs to see.
bool isOfUse(const ToolStatus& tool)
{
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

RegistrationWindow::RegistrationWindow(RegistrationModel& registration)
    : m_ui{std::make_unique<Ui::RegistrationWindow>()},
      m_registration{registration},
      m_landmarks{registration},
      m_bars{new ResidualBar{tr("mm"), this}}
{
    m_ui->setupUi(this);
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_ui->progress, m_ui->builtin, m_ui->primary, m_ui->next})
        keepPlaceWhenHidden(*widget);
    m_ui->scene->setBackground(palette().color(QPalette::Base));
    m_ui->patient->setText(
        tr("Patient: %1").arg(QString::fromStdString(m_registration.patient().name())));
    m_ui->tracker->setText(tr("Tracker: %1").arg(m_registration.trackerName()));
    m_scene = std::make_unique<RegistrationScene>(*m_ui->scene, m_registration);
    connectButtons();
    connectTable();
    connectModel();
    refresh();
    m_ui->primary->setFocus();
}

RegistrationWindow::~RegistrationWindow() = default;

void RegistrationWindow::connectButtons()
{
    connect(m_ui->steps, &StepList::chosen, this,
            [this](int step) { m_registration.enter(kSteps[std::size_t(step)]); });
    connect(m_ui->primary, &QPushButton::clicked, this, &RegistrationWindow::act);
    connect(m_ui->next, &QPushButton::clicked, this, &RegistrationWindow::enterNext);
    connect(m_ui->undo, &QPushButton::clicked, &m_registration, &RegistrationModel::undo);
    connect(m_ui->builtin, &QPushButton::clicked, &m_registration,
            &RegistrationModel::useBuiltinLandmarks);
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) {
        auto* goOn = new QShortcut{key, this};
        connect(goOn, &QShortcut::activated, this, [this] { mainButton().click(); });
    }
}

void RegistrationWindow::connectTable()
{
    m_ui->landmarks->setModel(&m_landmarks);
    m_ui->landmarks->setItemDelegateForColumn(LandmarkTableModel::Residual, m_bars);
    QHeaderView* header = m_ui->landmarks->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::Stretch);
    header->setSectionResizeMode(LandmarkTableModel::Touched, QHeaderView::ResizeToContents);
    header->setSectionResizeMode(LandmarkTableModel::Residual, QHeaderView::ResizeToContents);
    m_ui->landmarks->verticalHeader()->setMinimumSectionSize(kLeastRow);
    m_ui->landmarks->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    connect(m_ui->landmarks, &QTableView::clicked, this,
            [this](const QModelIndex& cell) { chooseLandmark(cell.row()); });
    auto* choose = new QShortcut{Qt::Key_Space, m_ui->landmarks};
    choose->setContext(Qt::WidgetShortcut);
    connect(choose, &QShortcut::activated, this,
            [this] { chooseLandmark(m_ui->landmarks->currentIndex().row()); });
    connect(m_ui->scene, &SceneView::clicked, &m_registration, &RegistrationModel::pick);
}

void RegistrationWindow::connectModel()
{
    connect(&m_registration, &RegistrationModel::changed, this, &RegistrationWindow::refresh);
    connect(&m_registration, &RegistrationModel::touched, this, [] { QApplication::beep(); });
    auto* live = new QTimer{this};
    connect(live, &QTimer::timeout, this, &RegistrationWindow::refreshProgress);
    live->start(kLiveInterval_ms);
    auto* slow = new QTimer{this};
    connect(slow, &QTimer::timeout, this, &RegistrationWindow::refreshTools);
    connect(slow, &QTimer::timeout, this, &RegistrationWindow::refreshStylus);
    slow->start(kToolsInterval_ms);
}

void RegistrationWindow::refresh()
{
    m_bars->setFullScale(std::max(kLeastFullScale_mm, m_landmarks.largestResidual_mm()));
    m_scene->refresh();
    m_ui->instruction->setText(m_registration.instruction());
    const QString problem = m_registration.problem();
    m_ui->problem->setText(problem.isEmpty() ? QString{} : QStringLiteral("▲ ") + problem);
    m_ui->place->setVisible(m_registration.step() == SiteStep::Verify);
    if (!m_registration.nextLandmark()) // what is marked is what a click would move
        m_ui->landmarks->clearSelection();
    refreshSteps();
    refreshButtons();
    refreshProgress();
    refreshTools();
    refreshStylus();
}

void RegistrationWindow::refreshSteps()
{
    std::vector<StepList::Step> steps;
    for (const SiteStep step : kSteps) {
        StepState state = m_registration.isDone(step) ? StepState::Done : StepState::Open;
        if (step == m_registration.step())
            state = StepState::Now;
        steps.push_back({stepTitle(step, m_landmarks), state, m_registration.whyNot(step)});
    }
    m_ui->steps->setSteps(steps);
}

void RegistrationWindow::refreshButtons()
{
    const SiteStep step = m_registration.step();
    m_ui->primary->setText(actionText());
    m_ui->primary->setVisible(step != SiteStep::Touch);
    m_ui->builtin->setVisible(step == SiteStep::Landmarks);
    m_ui->undo->setEnabled(m_registration.canUndo());
    m_ui->next->setVisible(step != SiteStep::Verify);
    if (step != SiteStep::Verify) {
        const QString whyNot = m_registration.whyNot(kSteps[std::size_t(step) + 1]);
        m_ui->next->setEnabled(whyNot.isEmpty() && !m_registration.isSwinging());
        m_ui->next->setToolTip(whyNot);
    }
    for (QPushButton* button : {m_ui->primary, m_ui->next})
        button->setDefault(button == &mainButton());
}

QString RegistrationWindow::actionText() const
{
    const bool again = m_registration.isDone(m_registration.step());
    switch (m_registration.step()) {
    case SiteStep::Tracker:
        return tr("&Use this tracker");
    case SiteStep::Stylus:
        if (m_registration.isSwinging())
            return tr("&Cancel");
        return again ? tr("&Swing again") : tr("&Start swinging");
    case SiteStep::Landmarks:
        return tr("&Use these landmarks");
    case SiteStep::Touch:
        break;
    case SiteStep::Fit:
        return again ? tr("&Fit again") : tr("&Fit");
    case SiteStep::Verify:
        return tr("&Finish");
    }
    return {};
}

QPushButton& RegistrationWindow::mainButton() const
{
    const SiteStep step = m_registration.step();
    const bool goesOn = m_registration.isDone(step) && !m_registration.isSwinging();
    return *(goesOn || step == SiteStep::Touch ? m_ui->next : m_ui->primary);
}

void RegistrationWindow::act()
{
    switch (m_registration.step()) {
    case SiteStep::Tracker:
        return m_registration.useTracker();
    case SiteStep::Stylus:
        return m_registration.isSwinging() ? m_registration.cancelSwing()
                                           : m_registration.startSwing();
    case SiteStep::Landmarks:
        return m_registration.acceptLandmarks();
    case SiteStep::Touch:
        return;
    case SiteStep::Fit:
        return m_registration.fit();
    case SiteStep::Verify:
        close();
    }
}

void RegistrationWindow::enterNext()
{
    m_registration.enter(kSteps[std::size_t(m_registration.step()) + 1]);
}

void RegistrationWindow::chooseLandmark(int row)
{
    const SiteStep step = m_registration.step();
    if (row >= 0 && (step == SiteStep::Landmarks || step == SiteStep::Touch))
        m_registration.choose(std::size_t(row));
}

void RegistrationWindow::refreshProgress()
{
    const int percent = qRound(100.0 * m_registration.progress());
    m_ui->progress->setVisible(m_registration.isSwinging() || percent > 0);
    m_ui->progress->setValue(percent);
    m_ui->progress->setFormat(m_registration.isSwinging() ? tr("Swing %p %")
                                                          : tr("Hold still %p %"));
}

void RegistrationWindow::refreshTools()
{
    QStringList texts;
    for (const ToolStatus& tool : m_registration.tools())
        if (isOfUse(tool))
            texts << toolText(tool);
    m_ui->tools->setText(texts.join(QLatin1Char('\n')));
}

void RegistrationWindow::refreshStylus()
{
    const auto stylus = m_registration.stylusOnAnatomy();
    m_ui->stylus->setText(stylus ? tr("%1 mm from %2\n%3 mm from the surface of %4")
                                       .arg(stylus->landmark_mm, 0, 'f', 1)
                                       .arg(stylus->nearestLandmark)
                                       .arg(stylus->surface_mm, 0, 'f', 1)
                                       .arg(stylus->nearestSurface)
                                 : tr("▲ The stylus is out of view"));
}

} // namespace carina
