#include "engine/net/node/fact_ledger.h"

#include "engine/session/facts/fact_codec.h"

namespace carina
{

const FactRecord* FactLedger::unstored(FactNumber number) const
{
    if (m_unstored.empty() || number < m_unstored.front().record.number
        || number > m_unstored.back().record.number)
        return nullptr;
    return &m_unstored[number.value - m_unstored.front().record.number.value].record;
}

void FactLedger::enter(const Fact& fact)
{
    m_decided.commit(fact);
    m_unstored.push_back({fact, toRecord(fact)});
}

std::vector<FactRecord> FactLedger::handOver()
{
    std::vector<FactRecord> facts;
    for (; m_handedOver < m_unstored.size(); ++m_handedOver)
        facts.push_back(m_unstored[m_handedOver].record);
    return facts;
}

FactLedger::Entry FactLedger::storeOldest()
{
    Entry entry = std::move(m_unstored.front());
    m_unstored.pop_front();
    m_stored.commit(entry.fact);
    return entry;
}

std::vector<FactRecord> FactLedger::giveUp()
{
    std::vector<FactRecord> undone;
    for (Entry& entry : std::exchange(m_unstored, {}))
        undone.push_back(std::move(entry.record));
    m_decided = m_stored;
    return undone;
}

} // namespace carina
