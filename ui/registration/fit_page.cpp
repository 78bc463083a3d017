#include "ui/registration/fit_page.h"

#include "ui/registration/error_table.h"
#include "ui/registration/landmark_list.h"
#include "widgets/plain_label.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace carina
{

FitPage::FitPage(RegistrationModel& registration)
    : RegistrationPage{registration},
      m_list{new LandmarkList{registration, this}},
      m_legend{new PlainLabel{this}},
      m_findings{new PlainLabel{this}},
      m_expected{new ErrorTable{this}},
      m_localisation{new PlainLabel{this}},
      m_swabbed{new PlainLabel{this}},
      m_surface{new QComboBox{this}},
      m_swab{new QPushButton{this}},
      m_cancel{new QPushButton{tr("Cance&l"), this}}
{
    m_list->setObjectName(QStringLiteral("residuals"));
    m_list->showColumns(
        {LandmarkTableModel::Name, LandmarkTableModel::Residual, LandmarkTableModel::LeftOut});
    m_legend->setObjectName(QStringLiteral("legend"));
    m_legend->setText(
        tr("Left out: %1.").arg(LandmarkTableModel::explanation(LandmarkTableModel::LeftOut)));
    m_findings->setObjectName(QStringLiteral("findings"));
    m_localisation->setObjectName(QStringLiteral("localisation"));
    m_swab->setObjectName(QStringLiteral("swab"));
    m_surface->setObjectName(QStringLiteral("surface"));
    m_surface->setAccessibleName(tr("Surface to slide the stylus over"));
    m_surface->addItems(registration.fitting().swabSurfaces());
    for (QLabel* label : {m_findings, m_legend, m_localisation, m_swabbed})
        label->setWordWrap(true);
    connect(m_swab, &QPushButton::clicked, this, &FitPage::swabOrRefine);
    connect(m_cancel, &QPushButton::clicked, this,
            [this] { this->registration().fitting().cancelSwab(); });
    layOut();
}

void FitPage::layOut()
{
    auto* swab = new QHBoxLayout;
    swab->addWidget(m_surface, 1);
    swab->addWidget(m_swab);
    swab->addWidget(m_cancel);
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins({});
    for (QWidget* widget : std::initializer_list<QWidget*>{m_findings, m_expected, m_localisation,
                                                           m_list, m_legend, m_swabbed})
        column->addWidget(widget);
    column->addLayout(swab);
    column->addStretch();
}

void FitPage::refresh()
{
    const FitTask& fitting = registration().fitting();
    const QStringList findings = fitting.findings();
    m_findings->setVisible(!findings.isEmpty());
    QStringList lines;
    for (const QString& finding : findings)
        lines << tr("▲ %1", "a warning").arg(finding);
    m_findings->setText(lines.join(QLatin1Char('\n')));
    m_expected->show(fitting.expected());
    const QString localisation = fitting.localisationText();
    m_localisation->setVisible(!localisation.isEmpty());
    m_localisation->setText(localisation);
    m_list->refresh();
    m_legend->setVisible(registration().site().registration.has_value());
    refreshSwab();
}

void FitPage::refreshLive() { refreshSwab(); }

void FitPage::refreshSwab()
{
    const FitTask& fitting = registration().fitting();
    const auto& registered = registration().site().registration;
    const bool swabbing = fitting.isSwabbing();
    for (QWidget* widget : std::initializer_list<QWidget*>{m_surface, m_swab})
        widget->setVisible(registered.has_value());
    m_surface->setEnabled(!swabbing);
    m_cancel->setVisible(swabbing);
    m_swab->setText(swabbing ? tr("&Refine") : tr("&Slide over it"));
    m_swab->setEnabled(!swabbing || fitting.swabPoints() >= FitTask::kFewestPoints);
    m_swabbed->setVisible(registered.has_value());
    if (swabbing)
        m_swabbed->setText(tr("%n points, %1 are the fewest.", nullptr, int(fitting.swabPoints()))
                               .arg(FitTask::kFewestPoints));
    else if (registered && registered->swab)
        m_swabbed->setText(tr("Refined on %1: %2 points are %3 mm (RMS) off it, %4 mm before.")
                               .arg(QString::fromStdString(registered->swab->surface))
                               .arg(registered->swab->points)
                               .arg(inMillimetres(metres(registered->swab->rms)), 0, 'f', 1)
                               .arg(inMillimetres(metres(registered->swab->startRms)), 0, 'f', 1));
    else
        m_swabbed->setText(tr("To refine the fit, slide the tip over a bone of the manikin:"));
}

QString FitPage::actionText() const
{
    if (registration().fitting().order() == TouchOrder::Exchanged)
        return tr("&Exchange them and fit");
    return registration().task(SiteStep::Fit).state == TaskState::Done ? tr("&Fit again")
                                                                       : tr("&Fit");
}

bool FitPage::canAct() const
{
    return registration().task(SiteStep::Fit).state != TaskState::Waits
           && !registration().fitting().isSwabbing();
}

void FitPage::act() { registration().fitting().fit(); }

void FitPage::swabOrRefine()
{
    FitTask& fitting = registration().fitting();
    if (fitting.isSwabbing())
        fitting.refine(m_surface->currentText());
    else
        fitting.startSwab();
}

} // namespace carina
