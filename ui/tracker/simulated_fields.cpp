#include "ui/tracker/simulated_fields.h"

#include "models/station/tool_status.h"
#include "ui/refusal_line.h"
#include "widgets/checked_spin_box.h"
#include "widgets/plain_label.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kSimulatedColumns = 2;

} // namespace

SimulatedFields::SimulatedFields(QWidget* parent)
    : QWidget{parent},
      m_rate{new CheckedDoubleSpinBox},
      m_dropouts{new CheckedDoubleSpinBox},
      m_laryngoscope{new QCheckBox{tr("&There is a laryngoscope, which shows the larynx")}},
      m_words{new PlainLabel}
{
    layOut();
    connect(m_rate, &QDoubleSpinBox::valueChanged, this, &SimulatedFields::edited);
    connect(m_dropouts, &QDoubleSpinBox::valueChanged, this, &SimulatedFields::edited);
    connect(m_laryngoscope, &QCheckBox::toggled, this, &SimulatedFields::edited);
    for (const QComboBox* sight : m_sights)
        connect(sight, &QComboBox::currentIndexChanged, this, &SimulatedFields::edited);
    fill({});
}

void SimulatedFields::layOut()
{
    m_rate->setObjectName(QStringLiteral("simulatedRate"));
    m_rate->setAccessibleName(tr("Exposures of the simulated tracker a second"));
    m_rate->setDecimals(1);
    m_rate->setRange(SimulatedOptions::kSlowest_Hz, SimulatedOptions::kFastest_Hz);
    m_rate->setSuffix(tr(" Hz"));
    m_dropouts->setObjectName(QStringLiteral("simulatedDropouts"));
    m_dropouts->setAccessibleName(tr("Share of the exposures that is not delivered"));
    m_dropouts->setDecimals(1);
    m_dropouts->setRange(0.0, SimulatedOptions::kMostDropouts_percent);
    m_dropouts->setSuffix(tr(" %"));
    m_laryngoscope->setObjectName(QStringLiteral("simulatedLaryngoscope"));
    m_words->setObjectName(QStringLiteral("simulatedWords"));
    m_words->setAccessibleName(tr("Option of a start that chooses the same"));
    m_words->setWordWrap(true);
    auto* refused = new RefusalLine;
    refused->watch(*m_rate);
    refused->watch(*m_dropouts);
    auto* form = new QFormLayout{this};
    form->addRow(tr("E&xposures a second"), m_rate);
    form->addRow(tr("&Not delivered"), m_dropouts);
    form->addRow(refused);
    form->addRow(m_laryngoscope);
    form->addRow(tr("Tools"), toolFields());
    form->addRow(m_words);
}

QWidget* SimulatedFields::toolFields()
{
    auto* fields = new QWidget;
    auto* grid = new QGridLayout{fields};
    grid->setContentsMargins({});
    for (const ToolRole role : simulatedRoles()) {
        const int place = int(m_sights.size());
        const QString name = toolRoleName(role);
        auto* sight = new QComboBox;
        sight->setObjectName(QStringLiteral("sight%1").arg(int(role)));
        sight->setAccessibleName(tr("How the simulated tool is seen: %1").arg(name));
        sight->addItem(tr("seen"), int(Sight::Always));
        sight->addItem(tr("hidden 2 of 10 s"), int(Sight::Hidden));
        sight->addItem(tr("half hidden 2 of 10 s"), int(Sight::Partly));
        const int row = place / kSimulatedColumns;
        const int column = 2 * (place % kSimulatedColumns);
        grid->addWidget(new PlainLabel{name}, row, column);
        grid->addWidget(sight, row, column + 1);
        m_sights.push_back(sight);
    }
    return fields;
}

void SimulatedFields::fill(const TrackerForm& form)
{
    const SimulatedOptions& options = form.simulated;
    const auto has = [](const std::vector<ToolRole>& tools, ToolRole role) {
        return std::ranges::count(tools, role) > 0;
    };
    m_rate->setValue(options.rate_Hz);
    m_dropouts->setValue(options.dropouts_percent);
    m_laryngoscope->setChecked(options.laryngoscope);
    for (std::size_t i = 0; i < m_sights.size(); ++i) {
        const ToolRole role = simulatedRoles()[i];
        const Sight sight = has(options.hidden, role)   ? Sight::Hidden
                            : has(options.partly, role) ? Sight::Partly
                                                        : Sight::Always;
        m_sights[i]->setCurrentIndex(m_sights[i]->findData(int(sight)));
    }
    edited();
}

void SimulatedFields::read(TrackerForm& form) const
{
    form.simulated = {.rate_Hz = m_rate->value(), .dropouts_percent = m_dropouts->value()};
    form.simulated.laryngoscope = m_laryngoscope->isChecked();
    for (std::size_t i = 0; i < m_sights.size(); ++i) {
        const auto sight = Sight(m_sights[i]->currentData().toInt());
        if (sight == Sight::Hidden)
            form.simulated.hidden.push_back(simulatedRoles()[i]);
        if (sight == Sight::Partly)
            form.simulated.partly.push_back(simulatedRoles()[i]);
    }
}

void SimulatedFields::enterTyped()
{
    m_rate->interpretText();
    m_dropouts->interpretText();
}

void SimulatedFields::edited()
{
    TrackerForm form;
    read(form);
    m_words->setText(
        tr("The same from the start on: --tracker %1").arg(simulatedName(form.simulated)));
    Q_EMIT changed();
}

} // namespace carina
