#include "ui/panels/breathing/gas_panel.h"

#include "models/physiology/drug_words.h"
#include "models/text/shown_as_is.h"
#include "ui/refusal_line.h"
#include "widgets/checked_spin_box.h"
#include "widgets/plain_label.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

constexpr int kDoseDecimals = 2;
constexpr double kLeastDose = 0.01; ///< of the unit of a drug, per kilogram
constexpr int kGivenLines = 2;
constexpr double kOxygenStep = 10.0; ///< per cent
constexpr double kObstructionStep = 10.0;
constexpr double kTubeStep_mm = 0.5;
constexpr int kPlaceLetters = 12; ///< of a place; its list is as wide as it has to be
// Of a tube, as its list has them: the first is that none is set.
constexpr int kNotSet = 0;
constexpr std::array kSettableSeats{TubeSeat::Trachea, TubeSeat::RightMain, TubeSeat::LeftMain,
                                    TubeSeat::Oesophagus, TubeSeat::None};

/// Shows a value without telling it back to the model; not while a person is typing into it.
void showValue(CheckedDoubleSpinBox& box, double value)
{
    const QSignalBlocker blocker{box};
    if (!box.hasFocus() || box.cleanText() == box.textFromValue(box.value()))
        box.setValue(value);
}

void showTick(QCheckBox& box, bool isChecked)
{
    const QSignalBlocker blocker{box};
    box.setChecked(isChecked);
}

/// "mg/kg", with a blank before it.
QString perKilogram(DrugKind kind)
{
    return GasPanel::tr("%1/kg", "unit of a drug, with its blank").arg(drugUnit(kind));
}

} // namespace

GasPanel::GasPanel(QWidget* parent)
    : QWidget{parent},
      m_obstacle{new PlainLabel},
      m_controls{new QWidget},
      m_oxygen{new CheckedDoubleSpinBox},
      m_mask{new QCheckBox{tr("Mask held on the face")}},
      m_probe{new QCheckBox{tr("Oximeter's probe on a finger")}},
      m_tube{new PlainLabel},
      m_tubeSeat{new QComboBox},
      m_tubeSize{new CheckedDoubleSpinBox},
      m_cuff{new QCheckBox{tr("Cuff inflated")}},
      m_stylet{new QPushButton{tr("Draw the stylet")}},
      m_obstruction{new CheckedDoubleSpinBox},
      m_drug{new QComboBox},
      m_dose{new CheckedDoubleSpinBox},
      m_whole{new PlainLabel},
      m_give{new QPushButton{tr("Give")}},
      m_given{new PlainLabel},
      m_refused{new RefusalLine},
      m_travelling{new PlainLabel},
      m_undo{new QPushButton{tr("Undo last change")}}
{
    layOut();
    explain();
    setFocusProxy(m_oxygen);
}

void GasPanel::layOut()
{
    auto* rows = new QFormLayout{m_controls};
    rows->setContentsMargins({});
    rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_oxygen->setObjectName(QStringLiteral("oxygen"));
    m_oxygen->setAccessibleName(tr("Inspired oxygen, per cent"));
    m_oxygen->setRange(100.0 * kRoomOxygen, 100.0 * kPureOxygen);
    m_oxygen->setDecimals(0);
    m_oxygen->setSingleStep(kOxygenStep);
    m_oxygen->setSuffix(tr(" %"));
    m_oxygen->setAlignment(Qt::AlignRight);
    m_mask->setObjectName(QStringLiteral("mask"));
    m_probe->setObjectName(QStringLiteral("probe"));
    rows->addRow(tr("Oxygen"), m_oxygen);
    rows->addRow(m_mask);
    rows->addRow(m_probe);
    layTube(*rows);
    layDrugs(*rows);
    m_refused->watch(*m_oxygen);
    m_refused->watch(*m_tubeSize);
    m_refused->watch(*m_obstruction);
    m_refused->watch(*m_dose);
    m_obstacle->setObjectName(QStringLiteral("obstacle"));
    m_obstacle->setWordWrap(true);
    m_travelling->setObjectName(QStringLiteral("travelling"));
    m_travelling->setWordWrap(true);
    m_travelling->setMinimumHeight(m_travelling->fontMetrics().lineSpacing());
    m_undo->setObjectName(QStringLiteral("undoGas"));
    auto* column = new QVBoxLayout{this};
    for (QWidget* widget :
         {static_cast<QWidget*>(m_obstacle), m_controls, static_cast<QWidget*>(m_refused),
          static_cast<QWidget*>(m_travelling), static_cast<QWidget*>(m_undo)})
        column->addWidget(widget);
    column->addStretch(1);
}

void GasPanel::layTube(QFormLayout& rows)
{
    m_tube->setObjectName(QStringLiteral("tubePlace"));
    m_tube->setAccessibleName(tr("Where the tube is"));
    m_tube->setWordWrap(true);
    m_cuff->setObjectName(QStringLiteral("cuff"));
    m_stylet->setObjectName(QStringLiteral("stylet"));
    m_stylet->setAccessibleName(tr("Draw the stylet out of the tube"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_cuff, 1);
    row->addWidget(m_stylet);
    m_obstruction->setObjectName(QStringLiteral("obstruction"));
    m_obstruction->setAccessibleName(tr("Obstruction of the tube, per cent"));
    m_obstruction->setRange(0.0, 100.0);
    m_obstruction->setDecimals(0);
    m_obstruction->setSingleStep(kObstructionStep);
    m_obstruction->setSuffix(tr(" %"));
    m_obstruction->setAlignment(Qt::AlignRight);
    rows.addRow(m_tube);
    laySetTube(rows);
    rows.addRow(row);
    rows.addRow(tr("Tube obstructed"), m_obstruction);
}

void GasPanel::laySetTube(QFormLayout& rows)
{
    m_tubeSeat->setObjectName(QStringLiteral("tubeSeat"));
    m_tubeSeat->setAccessibleName(tr("Where the console sets the tube"));
    m_tubeSeat->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_tubeSeat->setMinimumContentsLength(kPlaceLetters);
    m_tubeSeat->addItem(tr("as tracked"));
    for (const TubeSeat seat : kSettableSeats)
        m_tubeSeat->addItem(seatText(seat));
    m_tubeSize->setObjectName(QStringLiteral("tubeSize"));
    m_tubeSize->setAccessibleName(tr("Inner diameter of the tracheal tube, millimetres"));
    m_tubeSize->setRange(inMillimetres(kNarrowestTube), inMillimetres(kWidestTube));
    m_tubeSize->setDecimals(1);
    m_tubeSize->setSingleStep(kTubeStep_mm);
    m_tubeSize->setSuffix(tr(" mm"));
    m_tubeSize->setAlignment(Qt::AlignRight);
    auto* label = new PlainLabel{tr("Tube")};
    label->setBuddy(m_tubeSeat);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(m_tubeSeat, 1);
    row->addWidget(m_tubeSize);
    rows.addRow(row);
}

void GasPanel::layDrugs(QFormLayout& rows)
{
    m_drug->setObjectName(QStringLiteral("drug"));
    m_drug->setAccessibleName(tr("Drug"));
    for (const DrugKind kind : kDrugKinds)
        m_drug->addItem(drugText(kind));
    m_dose->setObjectName(QStringLiteral("dose"));
    m_dose->setDecimals(kDoseDecimals);
    m_dose->setAlignment(Qt::AlignRight);
    m_whole->setObjectName(QStringLiteral("wholeDose"));
    m_whole->setAccessibleName(tr("Dose for this patient"));
    m_give->setObjectName(QStringLiteral("give"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_whole, 1);
    row->addWidget(m_give);
    m_given->setObjectName(QStringLiteral("given"));
    m_given->setAccessibleName(tr("What was given in the last minute"));
    m_given->setWordWrap(true);
    m_given->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_given->setMinimumHeight(kGivenLines * m_given->fontMetrics().lineSpacing());
    rows.addRow(tr("Drug"), m_drug);
    rows.addRow(tr("Dose"), m_dose);
    rows.addRow(row);
    rows.addRow(m_given);
}

void GasPanel::explain()
{
    m_oxygen->setToolTip(tr("Oxygen in the gas that is supplied, by the mask or through the tube; "
                            "without both the patient breathes room air"));
    m_mask->setToolTip(
        tr("A tight mask. Once a tube is followed and lies outside of the trachea, a "
           "bag or ventilator reaches the patient only by it"));
    m_probe->setToolTip(tr("Without it the monitor shows no oxygen saturation"));
    m_cuff->setToolTip(tr("Without it a quarter of each breath escapes beside a tube that is "
                          "followed"));
    m_tubeSeat->setToolTip(
        tr("Where the tube is for the patient, whatever is noted of it. Not set: "
           "where it is noted; without a tube that is followed, none"));
    m_tubeSize->setToolTip(tr("Inner diameter of the tube that is set, 2 to 12 mm"));
    m_stylet->setToolTip(tr("It is back in the tube for the next try"));
    m_obstruction->setToolTip(tr("How much of its lumen a kink, a bite or secretions take, until "
                                 "it is taken out; 100 % let nothing through"));
    m_give->setToolTip(tr("Gives the dose at once; a drug that was given cannot be taken back"));
    m_undo->setToolTip(tr("Undoes the last change of gas or tube"));
}

void GasPanel::setModel(GasModel& model)
{
    m_model = &model;
    const auto vary = [this](void (*set)(GasSupply&, double), double value) {
        GasSupply gas = m_model->gas();
        set(gas, value);
        m_model->setGas(gas);
    };
    connect(m_oxygen, &QDoubleSpinBox::valueChanged, &model, [vary](double value) {
        vary([](GasSupply& gas, double percent) { gas.inspiredOxygen = 0.01 * percent; }, value);
    });
    connect(m_mask, &QCheckBox::toggled, &model, [vary](bool isHeld) {
        vary([](GasSupply& gas, double held) { gas.maskHeld = held > 0.0; }, isHeld ? 1.0 : 0.0);
    });
    connect(m_probe, &QCheckBox::toggled, &model, [vary](bool isOn) {
        vary([](GasSupply& gas, double on) { gas.probeOn = on > 0.0; }, isOn ? 1.0 : 0.0);
    });
    connectTube();
    connectDrugs();
    connect(m_undo, &QPushButton::clicked, &model, &GasModel::undo);
    connect(&model, &GasModel::changed, this, &GasPanel::refresh);
    offerDose();
    refresh();
}

void GasPanel::connectTube()
{
    connect(m_tubeSeat, &QComboBox::activated, this, [this](int place) {
        const SetTube set = m_model->tube();
        m_model->setTube(place == kNotSet ? SetTube{}
                                          : SetTube{kSettableSeats[std::size_t(place - 1)],
                                                    set.isSet() ? set.innerDiameter
                                                                : m_model->likelyTubeSize()});
    });
    connect(m_tubeSize, &QDoubleSpinBox::valueChanged, this, [this](double size) {
        if (const SetTube set = m_model->tube(); set.isSet())
            m_model->setTube({set.seat, millimetres(size)});
    });
    connect(m_cuff, &QCheckBox::toggled, m_model, &GasModel::setCuff);
    connect(m_stylet, &QPushButton::clicked, m_model, &GasModel::drawStylet);
    connect(m_obstruction, &QDoubleSpinBox::valueChanged, this,
            [this](double percent) { m_model->setObstruction(0.01 * percent); });
}

void GasPanel::connectDrugs()
{
    connect(m_drug, &QComboBox::currentIndexChanged, this, &GasPanel::offerDose);
    connect(m_dose, &QDoubleSpinBox::valueChanged, this, &GasPanel::refreshDose);
    connect(m_give, &QPushButton::clicked, this, [this] { m_model->give(drug(), dose_mgPerKg()); });
}

DrugKind GasPanel::drug() const { return kDrugKinds[std::size_t(m_drug->currentIndex())]; }

double GasPanel::dose_mgPerKg() const { return m_dose->value() / unitsPerMilligram(drug()); }

/// The usual one of the drug that is chosen.
void GasPanel::offerDose()
{
    const DrugKind kind = drug();
    {
        const QSignalBlocker blocker{m_dose};
        m_dose->setSuffix(perKilogram(kind));
        m_dose->setMaximum(unitsPerMilligram(kind) * m_model->mostDose_mgPerKg(kind));
        m_dose->setSingleStep(unitsPerMilligram(kind) * usualDose_mgPerKg(kind) / 10.0);
        m_dose->setMinimum(kLeastDose);
        m_dose->setValue(unitsPerMilligram(kind) * usualDose_mgPerKg(kind));
    }
    m_dose->setAccessibleName(tr("Dose of %1,%2", "drug; unit with its blank before it")
                                  .arg(drugText(kind), perKilogram(kind)));
    refreshDose();
}

void GasPanel::refreshDose()
{
    const double weight = m_model->weight_kg();
    m_whole->setText(tr("%1 for %2\u00a0kg", "drug and dose; weight of the patient")
                         .arg(doseText({drug(), dose_mgPerKg() * weight}))
                         .arg(weight, 0, 'g', 3));
    m_give->setAccessibleName(tr("Give %1").arg(doseText({drug(), dose_mgPerKg() * weight})));
}

void GasPanel::goToTube() { m_tubeSeat->setFocus(); }

void GasPanel::refreshTube()
{
    const QString where = m_model->tubeText();
    m_tube->setText(where);
    m_tube->setVisible(!where.isEmpty());
    const SetTube set = m_model->tube();
    const auto* const place = std::ranges::find(kSettableSeats, set.seat);
    m_tubeSeat->setCurrentIndex(set.isSet() ? 1 + static_cast<int>(place - kSettableSeats.begin())
                                            : kNotSet);
    showValue(*m_tubeSize,
              inMillimetres(set.isSet() ? set.innerDiameter : m_model->likelyTubeSize()));
    m_tubeSize->setEnabled(set.isSet());
    showTick(*m_cuff, m_model->isCuffInflated());
    m_stylet->setEnabled(m_model->hasStylet());
    showValue(*m_obstruction, 100.0 * m_model->obstruction());
    m_obstruction->setEnabled(m_model->hasTube());
}

void GasPanel::refresh()
{
    const QString obstacle = m_model->obstacle();
    m_obstacle->setText(obstacle);
    m_obstacle->setVisible(!obstacle.isEmpty());
    m_controls->setEnabled(obstacle.isEmpty());
    const GasSupply gas = m_model->gas();
    showValue(*m_oxygen, 100.0 * gas.inspiredOxygen);
    showTick(*m_mask, gas.maskHeld);
    showTick(*m_probe, gas.probeOn);
    refreshTube();
    const DrugKind kind = drug();
    m_dose->setMaximum(unitsPerMilligram(kind) * m_model->mostDose_mgPerKg(kind));
    refreshDose();
    const QString given = m_model->givenText();
    m_given->setText(given.isEmpty() ? QString{} : tr("● Given: %1").arg(given));
    m_travelling->setText(m_model->travellingText());
    m_undo->setVisible(!m_model->hasHistory()); // which has one for all panels
    m_undo->setEnabled(obstacle.isEmpty() && m_model->canUndo());
}

} // namespace carina
