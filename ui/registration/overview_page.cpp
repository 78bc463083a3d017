#include "ui/registration/overview_page.h"

#include "ui/registration/manikin_box.h"
#include "widgets/plain_label.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace carina
{

OverviewPage::OverviewPage(RegistrationModel& registration)
    : RegistrationPage{registration},
      m_health{new PlainLabel{this}},
      m_operator{new QLineEdit{this}},
      m_moved{new QPushButton{tr("The manikin was &moved…"), this}},
      m_whyNotMoved{new PlainLabel{this}},
      m_report{new QPushButton{tr("&Report as PDF…"), this}},
      m_manikin{new ManikinBox{registration.manikin(), this}}
{
    m_health->setWordWrap(true);
    m_health->setObjectName(QStringLiteral("health"));
    m_health->setAccessibleName(tr("State of the site"));
    m_operator->setObjectName(QStringLiteral("operator"));
    m_operator->setAccessibleName(tr("Your name, stored with the results"));
    m_operator->setMaxLength(80);
    connect(m_operator, &QLineEdit::editingFinished, this,
            [this] { this->registration().setOperator(m_operator->text()); });
    m_moved->setObjectName(QStringLiteral("moved"));
    m_moved->setToolTip(tr("Register it again by touching three of its landmarks"));
    connect(m_moved, &QPushButton::clicked, this,
            [this] { this->registration().touching().beginRelay(); });
    m_whyNotMoved->setObjectName(QStringLiteral("whyNotMoved"));
    m_whyNotMoved->setWordWrap(true);
    m_report->setObjectName(QStringLiteral("report"));
    connect(m_report, &QPushButton::clicked, this, &OverviewPage::reportWanted);
    layOut();
}

void OverviewPage::layOut()
{
    auto* save = new QPushButton{tr("&Export the site…"), this};
    connect(save, &QPushButton::clicked, this, &OverviewPage::chooseExport);
    auto* load = new QPushButton{tr("&Import a site…"), this};
    connect(load, &QPushButton::clicked, this, &OverviewPage::chooseImport);
    auto* form = new QFormLayout;
    form->addRow(tr("&Your name"), m_operator);
    auto* files = new QHBoxLayout;
    for (QPushButton* button : {save, load, m_report})
        files->addWidget(button);
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins({});
    column->addWidget(m_health);
    column->addLayout(form);
    column->addWidget(m_manikin);
    column->addWidget(m_moved);
    column->addWidget(m_whyNotMoved);
    column->addLayout(files);
    column->addStretch();
}

void OverviewPage::refresh()
{
    m_health->setText(registration().health().join(QStringLiteral("\n\n")));
    if (!m_operator->hasFocus())
        m_operator->setText(QString::fromStdString(registration().site().operatorName));
    const bool isRegistered = registration().site().registration.has_value();
    m_report->setEnabled(isRegistered);
    const QString whyNot = registration().touching().whyNoRelay();
    m_moved->setVisible(isRegistered);
    m_moved->setEnabled(whyNot.isEmpty());
    m_moved->setAccessibleDescription(whyNot);
    m_whyNotMoved->setVisible(isRegistered && !whyNot.isEmpty());
    m_whyNotMoved->setText(whyNot);
    m_manikin->refresh();
}

QString OverviewPage::actionText() const
{
    const SiteStep next = registration().nextStep();
    return next == SiteStep::Overview ? tr("&Finish") : tr("&Go on: %1").arg(stepTitle(next));
}

void OverviewPage::act()
{
    const SiteStep next = registration().nextStep();
    if (next == SiteStep::Overview)
        Q_EMIT finished();
    else
        registration().enter(next);
}

void OverviewPage::chooseExport()
{
    const QString file = QFileDialog::getSaveFileName(
        this, tr("Export the site"), QStringLiteral("site.json"), tr("Carina site (*.json)"));
    if (!file.isEmpty())
        registration().exportSite(file);
}

void OverviewPage::chooseImport()
{
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Import a site"), {}, tr("Carina site (*.json)"));
    if (!file.isEmpty())
        registration().importSite(file);
}

} // namespace carina
