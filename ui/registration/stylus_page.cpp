#include "ui/registration/stylus_page.h"

#include "engine/core/units.h"
#include "ui/registration/local_time.h"
#include "widgets/plain_label.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

namespace carina
{

StylusPage::StylusPage(RegistrationModel& registration)
    : RegistrationPage{registration},
      m_tip{new PlainLabel{this}},
      m_live{new PlainLabel{this}},
      m_spin{new QPushButton{this}}
{
    m_tip->setWordWrap(true);
    m_tip->setObjectName(QStringLiteral("tip"));
    m_tip->setAccessibleName(tr("Calibration of the stylus"));
    m_live->setWordWrap(true);
    m_live->setObjectName(QStringLiteral("swinging"));
    m_live->setAccessibleName(tr("Motion of the stylus during calibration"));
    m_spin->setObjectName(QStringLiteral("spin"));
    m_spin->setToolTip(
        tr("For tools whose shaft is drawn or used for aiming; landmarks need only the tip"));
    connect(m_spin, &QPushButton::clicked, this, [this] {
        StylusTask& stylus = this->registration().stylus();
        stylus.isSpinning() ? stylus.stop() : stylus.findAxis();
    });
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins({});
    for (QWidget* widget : std::initializer_list<QWidget*>{m_tip, m_live, m_spin})
        column->addWidget(widget);
    column->addStretch();
}

void StylusPage::refresh()
{
    const StylusTask& stylus = registration().stylus();
    m_tip->setText(calibration());
    m_spin->setEnabled(stylus.tip() && !stylus.isLookingForTip());
    m_spin->setText(stylus.isSpinning() ? tr("&Stop") : tr("Find the axis of its sha&ft"));
    refreshLive();
}

void StylusPage::refreshLive()
{
    m_live->setVisible(registration().stylus().isLookingForTip());
    m_live->setText(swinging());
}

QString StylusPage::calibration() const
{
    const StylusTip* tip = registration().stylus().tip();
    if (!tip)
        return tr("The tip of this stylus is not known yet.");
    QString text = tr("The tip is %1 mm from the markers. It stayed within %2 mm (RMS) of its "
                      "divot.")
                       .arg(inMillimetres(metres(tip->p_SQ.norm())), 0, 'f', 1)
                       .arg(inMillimetres(metres(tip->rms)), 0, 'f', 2);
    if (tip->poses > 0)
        text += QLatin1Char(' ')
                + tr("Its uncertainty is %1 mm (RMS), from %2 poses; %3 outliers were left out.")
                      .arg(inMillimetres(metres(std::sqrt(tip->covariance_S.trace()))), 0, 'f', 2)
                      .arg(tip->poses)
                      .arg(tip->outliers);
    if (const auto expected = registration().stylus().expectedTipError())
        text += QLatin1Char(' ')
                + tr("By the markers of the stylus, the tracker sees it within %1 mm (RMS).")
                      .arg(inMillimetres(*expected), 0, 'f', 2);
    text += QStringLiteral("\n\n") + tr("Calibrated: %1").arg(localTime(tip->calibratedAt));
    if (tip->axis)
        text += QStringLiteral("\n\n")
                + tr("The axis of its shaft is known; its poses differ by %1° (RMS).")
                      .arg(inDegrees(tip->axis->wobble), 0, 'f', 2);
    return text;
}

QString StylusPage::swinging() const
{
    const PivotProgress& progress = registration().stylus().pivot();
    QString text = tr("Rotated by %1°, %2° and %3° (RMS) about its three axes; %4 poses.")
                       .arg(inDegrees(progress.coverage.turns[0]), 0, 'f', 0)
                       .arg(inDegrees(progress.coverage.turns[1]), 0, 'f', 0)
                       .arg(inDegrees(progress.coverage.turns[2]), 0, 'f', 0)
                       .arg(progress.poses);
    if (progress.uncertainty)
        text += QLatin1Char(' ')
                + tr("Uncertainty of the tip so far: %1 mm (RMS).")
                      .arg(inMillimetres(metres(*progress.uncertainty)), 0, 'f', 2);
    return text;
}

QString StylusPage::actionText() const
{
    const StylusTask& stylus = registration().stylus();
    if (stylus.isLookingForTip())
        return tr("&Stop");
    return stylus.tip() ? tr("Find the tip &again") : tr("&Find the tip");
}

/// While the stylus is swung no key shall end it by habit.
bool StylusPage::isReady() const { return !registration().stylus().isLookingForTip(); }

void StylusPage::act()
{
    StylusTask& stylus = registration().stylus();
    stylus.isLookingForTip() ? stylus.stop() : stylus.findTip();
}

} // namespace carina
