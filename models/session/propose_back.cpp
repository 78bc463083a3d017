#include "models/session/propose_back.h"

#include <utility>

namespace carina
{

void proposeBack(SessionNode& node, StationId station, FactBody body, const QString& why,
                 ChangeHistory* history)
{
    if (why.isEmpty())
        node.propose(station, std::move(body));
    else if (history)
        history->refuse(why);
}

} // namespace carina
