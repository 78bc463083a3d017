#include "engine/net/anatomy_transfer/transfer_places.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace carina
{
namespace
{

using Places = std::span<const TransferPlace>;
using Indices = std::vector<std::size_t>;

Indices where(Places places, const auto& holds)
{
    Indices found;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (holds(places[i]))
            found.push_back(i);
    return found;
}

std::optional<std::size_t> slowest(Places places, const Indices& of)
{
    const auto slow = std::ranges::min_element(of, {}, [places](std::size_t i) {
        return std::pair{places[i].bytesPerSecond, -places[i].held.count()};
    });
    return slow == of.end() ? std::nullopt : std::optional{*slow};
}

/// Which of some ends for the newcomer. @param isAlike whether two places are of the same group
PlaceVerdict roomAmong(Places places, const Indices& some, const TransferPlace& newcomer,
                       const auto& isAlike)
{
    const auto groupOf = [&](const TransferPlace& place) {
        Indices group;
        std::ranges::copy_if(some, std::back_inserter(group),
                             [&](std::size_t i) { return isAlike(places[i], place); });
        return group;
    };
    Indices largest;
    for (const std::size_t i : some)
        if (Indices group = groupOf(places[i]); group.size() > largest.size())
            largest = std::move(group);
    if (largest.size() > groupOf(newcomer).size() + 1)
        return {true, slowest(places, largest)};
    Indices over;
    std::ranges::copy_if(some, std::back_inserter(over),
                         [&](std::size_t i) { return places[i].held >= kTransferTurn; });
    const auto ended = slowest(places, over);
    return {ended.has_value(), ended};
}

} // namespace

PlaceVerdict placeFor(const TransferPlace& newcomer, Places places)
{
    const auto isOfHolder = [](const TransferPlace& a, const TransferPlace& b) {
        return a.who == b.who;
    };
    const auto isOfAddress = [](const TransferPlace& a, const TransferPlace& b) {
        return a.from == b.from;
    };
    const auto own = where(places, [&](const auto& place) { return isOfHolder(place, newcomer); });
    if (newcomer.who.participant && own.size() >= kMostTransfersOfToken)
        return {};
    const auto near =
        where(places, [&](const auto& place) { return isOfAddress(place, newcomer); });
    if (near.size() >= kMostTransfersOfAddress)
        return roomAmong(places, near, newcomer, isOfHolder);
    if (places.size() >= kMostTransfers)
        return roomAmong(places, where(places, [](const auto&) { return true; }), newcomer,
                         isOfAddress);
    return {true, std::nullopt};
}

} // namespace carina
