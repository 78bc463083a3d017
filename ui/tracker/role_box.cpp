#include "ui/tracker/role_box.h"

#include "engine/core/expects.h"
#include "models/tracker/tracker_form.h"

#include <QComboBox>
#include <QCoreApplication>

namespace carina
{

QComboBox* roleBox(ToolRole role, const QString& label)
{
    auto* box = new QComboBox;
    box->setAccessibleName(label);
    for (const ToolRole offered : offeredRoles()) {
        const QString name = toolRoleName(offered);
        box->addItem(name.isEmpty() ? QCoreApplication::translate("RoleBox", "Other") : name,
                     int(offered));
    }
    box->setCurrentIndex(box->findData(int(role)));
    return box;
}

ToolRole chosenRole(const QWidget& box)
{
    const auto* roles = qobject_cast<const QComboBox*>(&box);
    CARINA_EXPECTS(roles != nullptr);
    return ToolRole(roles->currentData().toInt());
}

} // namespace carina
