#include "ui/registration/tools_page.h"

#include "models/station/tool_status.h"
#include "ui/refusal_line.h"
#include "ui/registration/local_time.h"
#include "ui/tracker/tool_layout_dialog.h"
#include "widgets/checked_spin_box.h"
#include "widgets/plain_label.h"

#include <QComboBox>
#include <QFormLayout>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>

namespace carina
{
namespace
{

constexpr double kThinnest_mm = 2.0;
constexpr double kThickest_mm = 20.0;

QString markOf(const ToolTask::PlaceRow& row)
{
    if (row.isNext)
        return QStringLiteral("●");
    return row.isTouched ? QStringLiteral("✓") : QStringLiteral("○");
}

} // namespace

ToolsPage::ToolsPage(RegistrationModel& registration)
    : RegistrationPage{registration},
      m_tools{new QComboBox{this}},
      m_diameterLabel{new PlainLabel{tr("Outer dia&meter"), this}},
      m_diameter{new CheckedDoubleSpinBox{this}},
      m_described{new PlainLabel{this}},
      m_places{new QListWidget{this}},
      m_check{new QPushButton{tr("Chec&k its tip"), this}},
      m_stop{new QPushButton{tr("&Stop"), this}},
      m_layout{new QPushButton{tr("Ma&rkers of a tool (.rom)…"), this}}
{
    m_tools->setObjectName(QStringLiteral("tool"));
    m_tools->setAccessibleName(tr("Tool to calibrate"));
    m_diameter->setObjectName(QStringLiteral("outerDiameter"));
    m_diameter->setAccessibleName(tr("Outer diameter of the tube, in millimetres"));
    m_diameter->setToolTip(tr("As printed on the tube, behind OD"));
    m_diameter->setRange(kThinnest_mm, kThickest_mm);
    m_diameter->setDecimals(1);
    m_diameter->setSingleStep(0.1);
    m_diameter->setSuffix(tr(" mm"));
    m_described->setObjectName(QStringLiteral("toolCalibration"));
    m_described->setAccessibleName(tr("Calibration of the tool"));
    m_described->setWordWrap(true);
    m_places->setObjectName(QStringLiteral("toolPlaces"));
    m_places->setAccessibleName(tr("Places of the tool to touch"));
    m_places->setWordWrap(true);
    m_places->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    m_places->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    m_check->setObjectName(QStringLiteral("checkTool"));
    m_check->setToolTip(tr("Touch its tip once: tells whether it was bent, or its markers moved"));
    m_stop->setObjectName(QStringLiteral("stopTool"));
    m_layout->setObjectName(QStringLiteral("toolLayout"));
    m_layout->setToolTip(tr("Shows where the markers of a tool definition of NDI are, and moves "
                            "them"));
    connectControls();
    layOut();
}

void ToolsPage::connectControls()
{
    connect(m_tools, &QComboBox::currentIndexChanged, this, [this](int index) {
        if (index >= 0 && std::size_t(index) < task().offered().size())
            task().choose(task().offered()[std::size_t(index)]);
    });
    connect(m_diameter, &QDoubleSpinBox::valueChanged, this,
            [this](double mm) { task().setOuterDiameter(millimetres(mm)); });
    connect(m_check, &QPushButton::clicked, this, [this] { task().beginCheck(); });
    connect(m_stop, &QPushButton::clicked, this, [this] { task().stop(); });
    connect(m_layout, &QPushButton::clicked, this, &ToolsPage::showLayout);
}

/// What was moved there is kept while it is closed.
void ToolsPage::showLayout()
{
    if (m_layoutDialog == nullptr)
        m_layoutDialog = new ToolLayoutDialog{this};
    m_layoutDialog->show();
    m_layoutDialog->raise();
    m_layoutDialog->activateWindow();
}

void ToolsPage::layOut()
{
    auto* form = new QFormLayout;
    auto* tool = new PlainLabel{tr("Too&l"), this};
    tool->setBuddy(m_tools);
    form->addRow(tool, m_tools);
    m_diameterLabel->setBuddy(m_diameter);
    form->addRow(m_diameterLabel, m_diameter);
    auto* refused = new RefusalLine{this};
    refused->watch(*m_diameter);
    form->addRow(refused);
    auto* hint =
        new PlainLabel{tr("Hold the tip of the stylus still at each place for a second, or "
                          "press Page Down. The tool may move meanwhile, while the tracker "
                          "sees both."),
                       this};
    hint->setWordWrap(true);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_check);
    buttons->addWidget(m_stop);
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins({});
    column->addLayout(form);
    column->addWidget(m_described);
    column->addLayout(buttons);
    column->addWidget(m_places);
    column->addWidget(hint);
    column->addWidget(m_layout);
    column->addStretch();
}

void ToolsPage::refresh()
{
    refreshTools();
    const SiteTool* tool = task().offered().empty() ? nullptr : task().calibration();
    QString text = task().described();
    if (tool) {
        text += QStringLiteral("\n\n") + tr("Calibrated: %1").arg(localTime(tool->calibratedAt));
        if (tool->check)
            text += QLatin1Char('\n') + tr("Checked: %1").arg(localTime(tool->check->at));
    }
    m_described->setText(text);
    refreshPlaces();
    m_check->setEnabled(tool && canAct() && !task().isTouching());
    m_stop->setEnabled(task().isTouching());
}

void ToolsPage::refreshTools()
{
    const auto& offered = task().offered();
    const QSignalBlocker blockTools{m_tools};
    if (m_tools->count() == 0)
        for (const ToolRole role : offered)
            m_tools->addItem(toolRoleName(role));
    m_tools->setEnabled(!offered.empty());
    const auto chosen = std::ranges::find(offered, task().chosen());
    m_tools->setCurrentIndex(offered.empty() ? -1 : int(chosen - offered.begin()));
    const bool isTube = !offered.empty() && task().chosen() == ToolRole::Tube;
    m_diameterLabel->setVisible(isTube);
    m_diameter->setVisible(isTube);
    const QSignalBlocker blockDiameter{m_diameter};
    m_diameter->setValue(inMillimetres(task().outerDiameter()));
}

void ToolsPage::refreshPlaces()
{
    const auto rows = task().places();
    while (m_places->count() > int(rows.size()))
        delete m_places->takeItem(m_places->count() - 1);
    for (int i = 0; i < int(rows.size()); ++i) {
        const ToolTask::PlaceRow& row = rows[std::size_t(i)];
        if (i == m_places->count())
            m_places->addItem(QString{});
        QListWidgetItem* item = m_places->item(i);
        item->setText(QStringLiteral("%1  %2").arg(markOf(row), row.name));
        QFont font = m_places->font();
        font.setBold(row.isNext);
        item->setFont(font);
        const QString state = row.isNext      ? tr("to be touched now")
                              : row.isTouched ? tr("touched")
                                              : tr("not touched yet");
        item->setData(Qt::AccessibleTextRole, tr("%1: %2").arg(row.name, state));
        if (row.isNext)
            m_places->scrollToItem(item);
    }
    m_places->updateGeometry();
}

QString ToolsPage::actionText() const
{
    if (task().next())
        return tr("&Take this point");
    if (task().isTouching())
        return tr("Start &again");
    const bool isCalibrated = !task().offered().empty() && task().calibration();
    return isCalibrated ? tr("Calibrate it &again") : tr("&Calibrate it");
}

bool ToolsPage::canAct() const { return task().whyNoTouch().isEmpty(); }

void ToolsPage::act()
{
    if (task().next())
        registration().takeNow();
    else
        task().beginCalibration();
}

} // namespace carina
