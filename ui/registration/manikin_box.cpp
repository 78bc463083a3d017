#include "ui/registration/manikin_box.h"

#include "models/text/shown_as_is.h"
#include "ui/refusal_line.h"
#include "widgets/checked_spin_box.h"
#include "widgets/plain_label.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include <cmath>

namespace carina
{
namespace
{

constexpr int kNotMeasured_mm = 99; ///< one below the least, shown as words

} // namespace

ManikinBox::ManikinBox(ManikinTask& task, QWidget* parent)
    : QGroupBox{tr("Differences between manikin and patient"), parent},
      m_task{task},
      m_makes{new QComboBox{this}},
      m_import{new QPushButton{tr("Import a profi&le…"), this}},
      m_measured{new CheckedSpinBox{this}},
      m_touch{new QPushButton{this}},
      m_skip{new QPushButton{tr("S&kip this place"), this}},
      m_comparison{new PlainLabel{this}}
{
    m_makes->setObjectName(QStringLiteral("manikin"));
    m_makes->setAccessibleName(tr("Make of the manikin"));
    m_makes->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_import->setToolTip(tr("A profile of a manikin, as JSON"));
    m_measured->setObjectName(QStringLiteral("teethToCarina"));
    m_measured->setAccessibleName(tr("Teeth to carina of the manikin, in millimetres"));
    m_measured->setToolTip(tr("Push a tube in until its tip is at the carina, and read its depth "
                              "at the upper incisors"));
    m_measured->setRange(kNotMeasured_mm, int(inMillimetres(kMostTeethToCarina)));
    m_measured->setSpecialValueText(tr("not measured"));
    m_measured->setSuffix(tr(" mm"));
    m_touch->setObjectName(QStringLiteral("touchAirway"));
    m_skip->setObjectName(QStringLiteral("skipAirway"));
    m_comparison->setObjectName(QStringLiteral("airways"));
    m_comparison->setAccessibleName(tr("Airway of the manikin and of the patient"));
    m_comparison->setWordWrap(true);
    m_comparison->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layOut();
    connectTask();
}

void ManikinBox::layOut()
{
    auto* form = new QFormLayout{this};
    auto* make = new QHBoxLayout;
    make->addWidget(m_makes, 1);
    make->addWidget(m_import);
    auto* label = new PlainLabel{tr("Ma&nikin"), this};
    label->setBuddy(m_makes);
    form->addRow(label, make);
    auto* airway = new QHBoxLayout;
    airway->addWidget(m_measured, 1);
    airway->addWidget(m_touch);
    airway->addWidget(m_skip);
    auto* length = new PlainLabel{tr("Tee&th to carina"), this};
    length->setBuddy(m_measured);
    form->addRow(length, airway);
    auto* refused = new RefusalLine{this};
    refused->watch(*m_measured);
    form->addRow(refused);
    form->addRow(m_comparison);
}

void ManikinBox::connectTask()
{
    connect(m_makes, &QComboBox::activated, this, [this](int make) {
        m_task.choose(make > 0 ? std::optional{std::size_t(make) - 1} : std::nullopt);
    });
    connect(m_import, &QPushButton::clicked, this, &ManikinBox::chooseImport);
    connect(m_measured, &QSpinBox::valueChanged, this, [this](int mm) {
        m_task.setMeasured(mm > kNotMeasured_mm ? std::optional{millimetres(mm)} : std::nullopt);
    });
    connect(m_touch, &QPushButton::clicked, this,
            [this] { m_task.isTouching() ? m_task.endTouch() : m_task.beginTouch(); });
    connect(m_skip, &QPushButton::clicked, this, [this] { m_task.skip(); });
}

void ManikinBox::refreshMakes()
{
    const std::vector<ManikinProfile> offered = m_task.offered();
    if (m_makes->count() == 0)
        m_makes->addItem(tr("not chosen"));
    while (m_makes->count() > int(offered.size()) + 1)
        m_makes->removeItem(m_makes->count() - 1);
    for (std::size_t i = 0; i < offered.size(); ++i) {
        const QString name = QString::fromStdString(offered[i].name);
        if (int(i) + 1 < m_makes->count())
            m_makes->setItemText(int(i) + 1, name);
        else
            m_makes->addItem(name);
    }
    const auto chosen = m_task.chosen();
    m_makes->setCurrentIndex(chosen ? int(*chosen) + 1 : 0);
    m_makes->setToolTip(
        shownAsIs(chosen ? QString::fromStdString(offered[*chosen].note) : QString{}));
}

void ManikinBox::refresh()
{
    refreshMakes();
    const QSignalBlocker blocker{m_measured};
    const auto measured = m_task.measured();
    m_measured->setValue(measured ? int(std::lround(inMillimetres(*measured))) : kNotMeasured_mm);
    const QString whyNot = m_task.whyNoTouch();
    m_touch->setText(m_task.isTouching() ? tr("&Stop touching") : tr("Tou&ch its airway"));
    m_touch->setEnabled(whyNot.isEmpty());
    m_touch->setToolTip(shownAsIs(whyNot));
    m_touch->setAccessibleDescription(whyNot);
    m_skip->setVisible(m_task.isTouching());
    m_comparison->setText(m_task.comparison().join(QLatin1Char('\n')));
}

void ManikinBox::chooseImport()
{
    const QString file = QFileDialog::getOpenFileName(this, tr("Import a manikin"), {},
                                                      tr("Profile of a manikin (*.json)"));
    if (!file.isEmpty())
        m_task.importFrom(file.toStdString());
}

} // namespace carina
