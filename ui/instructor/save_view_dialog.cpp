#include "ui/instructor/save_view_dialog.h"

#include "widgets/plain_label.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>

namespace carina
{

SaveViewDialog::SaveViewDialog(const SavedViews& views, QWidget* parent)
    : QDialog{parent}, m_views{views}, m_name{new QLineEdit}, m_fault{new PlainLabel}
{
    setWindowTitle(tr("Save this view"));
    m_name->setObjectName(QStringLiteral("viewName"));
    m_name->setMaxLength(SavedViews::kLongestName);
    m_fault->setObjectName(QStringLiteral("fault"));
    m_fault->setWordWrap(true);
    auto* buttons = new QDialogButtonBox{QDialogButtonBox::Save | QDialogButtonBox::Cancel};
    m_save = buttons->button(QDialogButtonBox::Save);
    m_save->setObjectName(QStringLiteral("saveView"));
    auto* form = new QFormLayout{this};
    form->addRow(tr("&Name"), m_name);
    form->addRow(m_fault);
    form->addRow(buttons);
    connect(m_name, &QLineEdit::textChanged, this, &SaveViewDialog::refresh);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    refresh();
}

QString SaveViewDialog::name() const { return m_name->text(); }

void SaveViewDialog::refresh()
{
    const QString fault = m_views.faultOf(name());
    m_fault->setText(fault);
    m_save->setEnabled(fault.isEmpty());
    m_save->setAccessibleDescription(fault);
}

} // namespace carina
