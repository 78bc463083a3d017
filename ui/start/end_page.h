#pragma once

#include "models/session/session_summary.h"

#include <QWidget>

namespace carina
{

/// After the end of a session: what happened, and whether there is to be another one.
class EndPage : public QWidget
{
    Q_OBJECT

public:
    explicit EndPage(const std::vector<SummaryLine>& told);

Q_SIGNALS:
    void anotherWanted();
};

} // namespace carina
