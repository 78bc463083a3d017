#include "ui/refusal_line.h"

namespace carina
{

RefusalLine::RefusalLine(QWidget* parent) : MessageLine{parent}
{
    setObjectName(QStringLiteral("refused"));
    setAccessibleName(tr("Why a number was refused"));
    setWordWrap(true);
    hide();
}

void RefusalLine::tell(const QString& why)
{
    show();
    warn(why);
}

void RefusalLine::forget()
{
    warn({});
    hide();
}

} // namespace carina
